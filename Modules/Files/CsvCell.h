#pragma once

#include <string>

namespace palpate
{
/// A text as a table cell that no spreadsheet interprets as a formula: if it begins with = + - @, a
/// tab or a carriage return and is not a number, or with apostrophes before these, it is prefixed
/// with an apostrophe.
std::string InertCell(const std::string& text);

/// The inverse of InertCell.
std::string TextOfCell(const std::string& cell);
} // namespace palpate
