#include "RoundNumber.h"

#include <cmath>

namespace palpate
{
double RoundNumberAbove(double size, std::initializer_list<double> mantissas)
{
  if (!(size > 0.0) || !std::isfinite(size))
  {
    return 1.0;
  }
  const double decade = std::pow(10.0, std::floor(std::log10(size)));
  for (const double mantissa : mantissas)
  {
    // Rounding must not push a round number one step up.
    if (mantissa * decade >= size * (1.0 - 1e-12))
    {
      return mantissa * decade;
    }
  }
  return 10.0 * decade;
}
} // namespace palpate
