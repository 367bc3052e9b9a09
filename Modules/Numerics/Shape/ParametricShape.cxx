#include "ParametricShape.h"

#include <vector>

namespace palpate
{
namespace
{
// The harmonic of degree 0 is this number.
double MeanHarmonic()
{
  return 1.0 / std::sqrt(4.0 * M_PI);
}

SphericalHarmonicEvaluator WithoutMean(const ParametricSphericalSurface& surface, int coordinate)
{
  std::vector<double> coefficients = surface.Coefficients(coordinate);
  coefficients[0] = 0.0;
  return {surface.Degree(), coefficients};
}
} // namespace

ParametricShape::ParametricShape(const ParametricSphericalSurface& surface)
    : Center(MeanHarmonic() * Vector3(surface.Coefficients(0)[0], surface.Coefficients(1)[0],
                                      surface.Coefficients(2)[0])),
      Coordinates{WithoutMean(surface, 0), WithoutMean(surface, 1), WithoutMean(surface, 2)},
      MaximumDegree(surface.Degree())
{
}

std::size_t ParametricShape::Bytes() const noexcept
{
  std::size_t bytes = sizeof(*this);
  for (const SphericalHarmonicEvaluator& each : this->Coordinates)
  {
    bytes += each.TableBytes();
  }
  return bytes;
}
} // namespace palpate
