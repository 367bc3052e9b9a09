#pragma once

#include "PalpateReportModule.h"

#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// Escapes text for an HTML or SVG element or a quoted attribute: the characters & < > " and ' are
/// replaced by references, line breaks and tabs by spaces, everything else that Printable replaces
/// as it does.
PALPATEREPORT_EXPORT std::string EscapeHtml(const std::string& text);

/// Names and values, not yet escaped.
using HtmlRows = std::vector<std::pair<std::string, std::string>>;

/// A table of two columns with a caption; everything is escaped.
PALPATEREPORT_EXPORT std::string HtmlTable(const std::string& caption, const HtmlRows& rows);
} // namespace palpate
