#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// Numbers as text and back, independent of the locale.
namespace palpate
{
/// Decimal text of a finite number, with as many digits as reading it back to the same bits needs
/// (at most 17).
std::string ExactText(double value);
/// The same for single precision (at most 9 digits).
std::string ExactText(float value);

/// A number with a fixed count of digits behind the point, "0.00" for what rounds to minus zero; a
/// dash if it is not finite.
std::string FixedText(double value, int decimals);

/// A number with a count of significant digits, no trailing zeros, in the shorter of plain and
/// exponent form; a dash if it is not finite.
std::string SignificantText(double value, int digits = 6);

/// FixedText with as many more digits as the text needs to compare with `limit` as the value does:
/// below, above or equal. So 0.98499 against 0.985 is not written "0.985". A value equal to the
/// limit is written with all its digits.
std::string TextAgainstLimit(double value, double limit, int decimals);
/// The same with SignificantText.
std::string SignificantAgainstLimit(double value, double limit, int digits);

/// "1 hole", "2 holes".
std::string CountText(std::int64_t count, std::string_view one, std::string_view several);

/// The finite number that the whole text is, blanks around it left out; nothing otherwise.
std::optional<double> ParseNumber(std::string_view text);
std::optional<int> ParseInteger(std::string_view text);
} // namespace palpate
