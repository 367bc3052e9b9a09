#include "DeviceFrame.h"

#include <cmath>

namespace palpate
{
DeviceFrame::DeviceFrame(const Matrix3& rotation, double scale, const Vector3& originWorld)
    : Rotation(rotation), Turn(rotation), Scale(scale), OriginWorld(originWorld)
{
}

Status DeviceFrame::Check() const
{
  // Accepts rotations that were written with seven digits.
  constexpr double tolerance = 1e-6;
  const double skew = (this->Rotation * this->Rotation.transpose() - Matrix3::Identity()).norm();
  if (!(skew <= tolerance) || !(this->Rotation.determinant() > 0.0))
  {
    return Status::Failure("The device's orientation in the world is not a rotation.");
  }
  if (!(this->Scale > 0.0) || !std::isfinite(this->Scale) || !this->OriginWorld.allFinite())
  {
    return Status::Failure("The device's scale and place in the world must be finite numbers, and "
                           "the scale positive.");
  }
  return Status::Success();
}

ToolPose DeviceFrame::PoseWorld(const DeviceSample& sample) const noexcept
{
  const Eigen::Map<const Eigen::Quaterniond> orientation(sample.Orientation.data());
  return {this->OriginWorld + this->Scale * (this->Rotation * Vector3(sample.Position)),
          this->Turn * orientation};
}
} // namespace palpate
