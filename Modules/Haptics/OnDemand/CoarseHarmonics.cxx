#include "CoarseHarmonics.h"

#include "RadiusRange.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
CoarseHarmonics MakeCoarseHarmonics(const SphericalHarmonicModel& model, int degree)
{
  const SphericalHarmonicModel cut = model.WithDegree(std::min(degree, model.Degree()));
  std::vector<double> coefficients = cut.Coefficients();
  std::vector<double> dropped = model.Coefficients();
  std::fill_n(dropped.begin(), coefficients.size(), 0.0);
  const double unit = std::sqrt(4.0 * M_PI); // c_00 of a sphere of radius 1
  constexpr double Tolerance = 0.01;
  const RadiusRange range =
      FindRadiusRange(SphericalHarmonicModel(model.Degree(), dropped, model.CenterWorld()),
                      Tolerance * std::abs(coefficients[0]) / unit);
  const double raised = std::max(range.Upper, 0.0);
  coefficients[0] += raised * unit;
  return {SphericalHarmonicModel(cut.Degree(), coefficients, model.CenterWorld()), raised};
}
} // namespace palpate
