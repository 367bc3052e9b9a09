#pragma once

#include "PalpateReportModule.h"

#include <string>

namespace palpate
{
/// Escapes text for an HTML or SVG element or a quoted attribute: the characters & < > " and ' are
/// replaced by references, line breaks and tabs by spaces, everything else that Printable replaces
/// as it does.
PALPATEREPORT_EXPORT std::string EscapeHtml(const std::string& text);
} // namespace palpate
