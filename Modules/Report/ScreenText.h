#pragma once

#include "PalpateReportModule.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// Makes text with names from files safe to display in a terminal or a window, on one line:
/// characters that control a terminal, break lines, are invisible, change the text direction, or
/// are not UTF-8 are replaced byte by byte, as in `\x1b`.
PALPATEREPORT_EXPORT std::string Printable(const std::string& text);

/// Whether all bytes form characters of UTF-8 (RFC 3629).
PALPATEREPORT_EXPORT bool IsUtf8(const std::string& text);

/// The first characters (UTF-8) of a text, ending with an ellipsis if it is longer.
PALPATEREPORT_EXPORT std::string Shortened(const std::string& text, std::size_t characters);
} // namespace palpate
