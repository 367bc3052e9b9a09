#include "RegistrationStep.h"

#include "SymmetricEigen.h"

#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr int PoseUnknowns = 6;

// exp of a rotation vector (rad).
Matrix3 TurnOf(const Vector3& vector)
{
  const double angle = vector.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix()
                     : Matrix3::Identity();
}
} // namespace

int RegistrationStep::Count() const noexcept
{
  switch (this->Kind)
  {
  case RegistrationKind::Rigid:
    return PoseUnknowns;
  case RegistrationKind::Similarity:
    return PoseUnknowns + 1;
  case RegistrationKind::Affine:
    break;
  }
  return 3 + 9;
}

Eigen::VectorXd RegistrationStep::Derivatives(const Vector3& point, const Vector3& direction) const
{
  Eigen::VectorXd row(this->Count());
  const Vector3 arm = (point - this->Pivot) / this->Radius;
  row.head<3>() = direction;
  if (this->Kind == RegistrationKind::Affine)
  {
    Eigen::Map<Matrix3>(row.data() + 3) = direction * arm.transpose();
    return row;
  }
  row.segment<3>(3) = arm.cross(direction);
  if (this->Kind == RegistrationKind::Similarity)
  {
    row[PoseUnknowns] = arm.dot(direction);
  }
  return row;
}

Eigen::Affine3d RegistrationStep::MapOf(const Eigen::VectorXd& unknowns) const
{
  Matrix3 linear;
  if (this->Kind == RegistrationKind::Affine)
  {
    linear = Matrix3::Identity() + Eigen::Map<const Matrix3>(unknowns.data() + 3) / this->Radius;
  }
  else
  {
    linear = TurnOf(unknowns.segment<3>(3) / this->Radius);
    if (this->Kind == RegistrationKind::Similarity)
    {
      linear *= std::exp(unknowns[PoseUnknowns] / this->Radius);
    }
  }
  Eigen::Affine3d map;
  map.linear() = linear;
  map.translation() = this->Pivot + Vector3(unknowns.head<3>()) - linear * this->Pivot;
  return map;
}

PredictedPoseError PredictedPoseError::Of(const Eigen::MatrixXd& normal, double radius,
                                          double noise)
{
  constexpr double Flat = 1e-9; // of the largest eigenvalue: rounding of exact symmetry
  const SymmetricEigen eigen(normal);
  const double largest = eigen.Values[eigen.Values.size() - 1];
  double turn = 0.0;
  double shift = 0.0;
  for (Eigen::Index k = 0; k < eigen.Values.size(); ++k)
  {
    const double variance = eigen.Values[k] > Flat * largest
                                ? noise * noise / eigen.Values[k]
                                : std::numeric_limits<double>::infinity();
    const auto add = [variance](double share, double& sum)
    { sum += share > Flat ? share * variance : 0.0; };
    add(eigen.Vectors.col(k).head<3>().squaredNorm(), shift);
    add(eigen.Vectors.col(k).segment<3>(3).squaredNorm(), turn);
  }
  return {std::sqrt(turn) / radius, std::sqrt(shift)};
}
} // namespace palpate
