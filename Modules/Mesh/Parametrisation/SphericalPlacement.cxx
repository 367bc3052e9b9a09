#include "SphericalPlacement.h"

#include "SingularValues.h"

#include <cmath>

namespace palpate
{
namespace
{
// Singular values below this share of the largest are rounding.
constexpr double LeastShare = 1e-12;
// Semi-axes are similar if the shorter one is more than this share of the longer one.
constexpr double SimilarShare = 0.9;

// Of C with rotations on both sides: the last value has the sign of det C.
Status Factorise(const Matrix3& degreeOne, SingularValues& factors)
{
  const double scale = degreeOne.allFinite() ? degreeOne.cwiseAbs().maxCoeff() : 0.0;
  if (!std::isnormal(scale))
  {
    return Status::Failure("The surface's ellipsoid needs finite axes with a length.");
  }
  factors = SingularValuesOf(degreeOne / scale);
  for (Matrix3* const side : {&factors.Left, &factors.Right})
  {
    if (side->determinant() < 0.0)
    {
      side->col(2) = -side->col(2);
      factors.Values[2] = -factors.Values[2];
    }
  }
  if (!(factors.Values[1] + factors.Values[2] > LeastShare * factors.Values[0]))
  {
    return Status::Failure("The surface's ellipsoid does not determine a rotation.");
  }
  factors.Values *= scale;
  return Status::Success();
}

SphericalPlacement PlacementOf(const Matrix3& rotation, const Vector3& values)
{
  return {rotation, (values[1] + values[2]) / values[0]};
}

// +1 or -1 that makes the component of largest magnitude positive.
double SignOf(const Vector3& axis)
{
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0.0 ? -1.0 : 1.0;
}
} // namespace

Status PlaceByPolarFactor(const Matrix3& degreeOne, SphericalPlacement& placement)
{
  SingularValues factors;
  if (Status status = Factorise(degreeOne, factors); !status.IsOk())
  {
    return status;
  }
  placement = PlacementOf(factors.NearestOrthogonal(), factors.Values);
  return Status::Success();
}

Status PlaceByEllipsoid(const Matrix3& degreeOne, EllipsoidPlacement& placement)
{
  SingularValues factors;
  if (Status status = Factorise(degreeOne, factors); !status.IsOk())
  {
    return status;
  }
  const double first = SignOf(factors.Left.col(0));
  const double second = SignOf(factors.Left.col(1));
  const Vector3 signs(first, second, first * second);
  placement.Axes = factors.Left * signs.asDiagonal();
  placement.Placement =
      PlacementOf((factors.Right * signs.asDiagonal()).transpose(), factors.Values);
  placement.SemiAxes = factors.Values;
  placement.IsLongestPairAmbiguous = factors.Values[1] > SimilarShare * factors.Values[0];
  placement.IsShortestPairAmbiguous =
      std::abs(factors.Values[2]) > SimilarShare * factors.Values[1];
  return Status::Success();
}
} // namespace palpate
