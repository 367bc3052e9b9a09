#pragma once

#include "PalpateSessionModule.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// Text from a file as a terminal may show it: control characters as \x1b, line breaks too.
PALPATESESSION_EXPORT std::string Printable(const std::string& text);

/// The first characters (UTF-8) of a text, the last of them an ellipsis where it is longer.
PALPATESESSION_EXPORT std::string Shortened(const std::string& text, std::size_t characters);
} // namespace palpate
