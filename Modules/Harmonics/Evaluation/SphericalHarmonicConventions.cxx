#include "SphericalHarmonicConventions.h"

#include "SphericalHarmonicBasis.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr double Root2 = 1.41421356237309504880;

double PhaseSign(int order)
{
  return order % 2 == 0 ? 1.0 : -1.0;
}

std::size_t SpharmPdmRow(int l, int m)
{
  if (m == 0)
  {
    return static_cast<std::size_t>(l * l);
  }
  return static_cast<std::size_t>(m > 0 ? l * l + 2 * m - 1 : l * l - 2 * m);
}

double SpharmPdmScale(int m)
{
  return m == 0 ? 1.0 : Root2 * PhaseSign(m);
}
} // namespace

int DegreeOfCount(std::size_t count) noexcept
{
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(count))));
  return side > 0 && side * side == count ? static_cast<int>(side) - 1 : -1;
}

std::vector<double> ToSpharmPdm(const std::vector<double>& coefficients)
{
  std::vector<double> rows(coefficients.size());
  for (int l = 0; l <= DegreeOfCount(coefficients.size()); ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      rows[SpharmPdmRow(l, m)] =
          SpharmPdmScale(m) * coefficients[SphericalHarmonicBasis::Index(l, m)];
    }
  }
  return rows;
}

std::vector<double> FromSpharmPdm(const std::vector<double>& rows)
{
  std::vector<double> coefficients(rows.size());
  for (int l = 0; l <= DegreeOfCount(rows.size()); ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      coefficients[SphericalHarmonicBasis::Index(l, m)] =
          rows[SpharmPdmRow(l, m)] / SpharmPdmScale(m);
    }
  }
  return coefficients;
}
} // namespace palpate
