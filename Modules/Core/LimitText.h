#pragma once

#include <string>

namespace palpate
{
/// `value` with `decimals` digits after the point, or as many more as it takes for the text to
/// stand to `limit` as the value does: below, above or equal. So 0.98499 against 0.985 is not
/// written "0.985". A limit against itself is written with all its digits. Independent of the
/// locale.
std::string TextAgainstLimit(double value, double limit, int decimals);

/// The same with `digits` significant digits at first, in the shortest of plain and exponent form.
std::string SignificantAgainstLimit(double value, double limit, int digits);
} // namespace palpate
