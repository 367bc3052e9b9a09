#include "HeldPose.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
void HeldPose::Turn(const Vector3& rotation) noexcept
{
  const double angle = rotation.norm();
  if (angle > 0.0)
  {
    const Eigen::AngleAxisd turn(angle, rotation / angle);
    for (Eigen::Affine3d* pose : {&this->Now, &this->Hand})
    {
      const Vector3 pivot = *pose * this->Fit.Pivot();
      *pose = Eigen::Translation3d(pivot) * turn * Eigen::Translation3d(-pivot) * *pose;
    }
  }
}

double HeldPose::Step() noexcept
{
  const Vector3 force = this->Fit.At(this->Now).Force - this->Spring * this->Stretch();
  const Vector3 step = force / (this->Spring + this->Fit.Stiffness());
  this->Now.pretranslate(step);
  return step.norm();
}

double HeldPose::Energy() const noexcept
{
  return this->Fit.At(this->Now).Energy + 0.5 * this->Spring * this->Stretch().squaredNorm();
}

Eigen::Affine3d PoseRamp::At(double time) const noexcept
{
  const double part = std::clamp(time / this->Duration, 0.0, 1.0);
  const double share = part * part * (3.0 - 2.0 * part);
  const double first = std::cbrt(this->From.linear().determinant());
  const double last = std::cbrt(this->To.linear().determinant());
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(Matrix3(this->From.linear() / first))
          .slerp(share, Eigen::Quaterniond(Matrix3(this->To.linear() / last)));
  const Vector3 start = this->From * this->Pivot;
  const Vector3 place = start + share * (this->To * this->Pivot - start);
  return Eigen::Translation3d(place) * turn * Eigen::Scaling(first + share * (last - first)) *
         Eigen::Translation3d(-this->Pivot);
}
} // namespace palpate
