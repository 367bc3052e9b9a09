#pragma once

#include "PalpateIOModule.h"

#include <optional>
#include <string>
#include <string_view>

namespace palpate
{
/// The bytes of a Base64 text, in which blanks and line ends are ignored; nothing if it has other
/// characters or an incomplete last group. Source: RFC 4648.
PALPATEIO_EXPORT std::optional<std::string> DecodedBase64(std::string_view text);
} // namespace palpate
