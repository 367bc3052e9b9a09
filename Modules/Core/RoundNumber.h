#pragma once

#include <initializer_list>

namespace palpate
{
/// The smallest number that reads well on an axis and is at least `size`, up to rounding: one of
/// `mantissas` (rising, from 1 to below 10) times a power of ten. 1 if `size` is not a positive
/// finite number.
double RoundNumberAbove(double size, std::initializer_list<double> mantissas = {1.0, 2.0, 5.0});
} // namespace palpate
