#pragma once

namespace palpate
{
///@{ The cubic from 0 at 0 to 1 at 1 whose slope is 0 at both, and its slope; `t` from 0 to 1.
constexpr double SmoothStep(double t) noexcept
{
  return t * t * (3.0 - 2.0 * t);
}
constexpr double SmoothStepSlope(double t) noexcept
{
  return 6.0 * t * (1.0 - t);
}
///@}
} // namespace palpate
