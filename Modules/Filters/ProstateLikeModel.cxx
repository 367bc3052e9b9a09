#include "ProstateLikeModel.h"

#include "SeededNoise.h"
#include "SphericalHarmonicBasis.h"
#include "SphericalHarmonicProjection.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr int HighestBumpDegree = 8;

// Radius (mm) of the smooth body before the bumps.
double SmoothRadius(const Vector3& u)
{
  const double ellipsoid = 1.0 / std::sqrt(std::pow(u.x() / 24.0, 2) + std::pow(u.y() / 20.0, 2) +
                                           std::pow(u.z() / 22.0, 2));
  const double rectum = 0.08 * std::exp(-6.0 * (1.0 - u.y()));
  const double apex = 0.06 * std::exp(-4.0 * (1.0 + u.z()));
  return ellipsoid * (1.0 - rectum - apex);
}

} // namespace

RadialModel MakeProstateLikeModel(int degree, std::uint64_t seed, const Vector3& centerWorld)
{
  // The body is smooth: its harmonics beyond degree 40 are below rounding.
  std::vector<double> coefficients = ProjectOnHarmonics(degree, degree + 40, SmoothRadius);
  for (int l = 2; l <= std::min(degree, HighestBumpDegree); ++l)
  {
    // One stream per degree, so that a body of lower degree has the same bumps up to there.
    SeededNoise noise(seed, static_cast<std::uint64_t>(l));
    const double deviation = std::pow(2.0 / l, 2);
    for (int m = -l; m <= l; ++m)
    {
      coefficients[SphericalHarmonicBasis::Index(l, m)] += deviation * noise.Next();
    }
  }
  return {degree, std::move(coefficients), centerWorld};
}
} // namespace palpate
