#pragma once

#include "PalpateReportModule.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// Text that holds names from files as a terminal or a window may show it, on one line: as \x1b,
/// byte by byte, what controls a terminal, breaks lines, is invisible, changes the direction of
/// writing, or is no UTF-8.
PALPATEREPORT_EXPORT std::string Printable(const std::string& text);

/// The first characters (UTF-8) of a text, the last of them an ellipsis where it is longer.
PALPATEREPORT_EXPORT std::string Shortened(const std::string& text, std::size_t characters);
} // namespace palpate
