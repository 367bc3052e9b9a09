#pragma once

#include "PalpateSessionModule.h"

#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// Text as it may stand in an HTML or SVG element or in a quoted attribute: the characters & < > "
/// and ' replaced by references, line breaks by spaces, what is no UTF-8 by U+FFFD; other control
/// characters are left out.
PALPATESESSION_EXPORT std::string EscapeHtml(const std::string& text);

/// A number with a fixed count of digits behind the point, independent of the locale; a dash where
/// it is not finite.
PALPATESESSION_EXPORT std::string FixedText(double number, int digits);

/// A number with a count of significant digits, in the shortest of plain and exponent form.
PALPATESESSION_EXPORT std::string SignificantText(double number, int digits);

/// Names and values, not yet escaped.
using HtmlRows = std::vector<std::pair<std::string, std::string>>;

/// A table of two columns with a caption; everything is escaped.
PALPATESESSION_EXPORT std::string HtmlTable(const std::string& caption, const HtmlRows& rows);
} // namespace palpate
