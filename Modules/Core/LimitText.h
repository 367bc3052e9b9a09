#pragma once

#include <string>

namespace palpate
{
/// `value` with `decimals` digits after the point, or with as many more as the text needs to
/// compare with `limit` as the value does: below, above or equal. So 0.98499 against 0.985 is not
/// written "0.985". A value equal to the limit is written with all its digits. Independent of the
/// locale.
std::string TextAgainstLimit(double value, double limit, int decimals);

/// The same starting from `digits` significant digits, in the shorter of plain and exponent form.
std::string SignificantAgainstLimit(double value, double limit, int digits);
} // namespace palpate
