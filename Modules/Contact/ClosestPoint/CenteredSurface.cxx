#include "CenteredSurface.h"

#include <cmath>

namespace palpate
{
namespace
{
SurfaceEvaluator WithoutMeans(const SurfaceModel& surface)
{
  SurfaceEvaluator::Coefficients coefficients{surface.Coefficients(0), surface.Coefficients(1),
                                              surface.Coefficients(2)};
  for (auto& each : coefficients)
  {
    each[0] = 0.0;
  }
  return {surface.Degree(), coefficients};
}
} // namespace

// The harmonic of degree 0 is 1 / sqrt(4 pi).
CenteredSurface::CenteredSurface(const SurfaceModel& surface)
    : Evaluator(WithoutMeans(surface)),
      Center(Vector3(surface.Coefficients(0)[0], surface.Coefficients(1)[0],
                     surface.Coefficients(2)[0]) /
             std::sqrt(4.0 * M_PI)),
      MaximumDegree(surface.Degree())
{
}
} // namespace palpate
