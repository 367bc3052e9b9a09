#pragma once

#include "PalpateIOModule.h"

#include <string>
#include <string_view>

namespace palpate
{
/// The bytes as a "data:" URI in Base64 (RFC 2397).
PALPATEIO_EXPORT std::string DataUri(const std::string& mediaType, std::string_view bytes);
} // namespace palpate
