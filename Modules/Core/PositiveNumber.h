#pragma once

#include <cmath>

namespace palpate
{
/// Whether a number is above 0 and finite, as lengths, forces and spacings from outside must be.
inline bool IsPositive(double number) noexcept
{
  return number > 0.0 && std::isfinite(number);
}
} // namespace palpate
