#pragma once

#include "PalpateIOModule.h"

#include <optional>
#include <string>
#include <string_view>

namespace palpate
{
/// Decimal text of a finite number, with as many digits as reading it back to the same bits needs
/// (at most 17). Independent of the locale.
PALPATEIO_EXPORT std::string ExactText(double value);
/// The same for single precision (at most 9 digits).
PALPATEIO_EXPORT std::string ExactText(float value);

/// The finite number that the whole text is, blanks around it left out; nothing otherwise.
/// Independent of the locale.
PALPATEIO_EXPORT std::optional<double> ParseNumber(std::string_view text);
PALPATEIO_EXPORT std::optional<int> ParseInteger(std::string_view text);
} // namespace palpate
