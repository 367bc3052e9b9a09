#include "PointDerivativeBounds.h"

#include "DirectionGap.h"
#include "IcosahedronDirections.h"
#include "ParametricSample.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
PointDerivativeBounds::PointDerivativeBounds(const ParametricShape& shape) : Point{}
{
  const double degree = shape.Degree();
  const IcosahedronDirections sphere(std::max(1, shape.Degree()));
  for (const Vector3& parameter : sphere.Directions())
  {
    const auto sample = shape.EvaluateSecondOrder(parameter);
    this->Point[0] = std::max(this->Point[0], sample.Point.norm());
    this->Point[1] = std::max(this->Point[1], LargestFirst(sample));
    this->Point[2] = std::max(this->Point[2], LargestSecond(sample));
  }
  const double fall = std::cos(degree * LargestGap(sphere));
  for (double& bound : this->Point)
  {
    bound /= fall;
  }
  // A symmetric form is largest with three equal arguments; the asymmetric part of the covariant
  // derivative is the curvature of the sphere, 1, times x'.
  this->PointThird = degree * this->Point[2] + this->Point[1];
}
} // namespace palpate
