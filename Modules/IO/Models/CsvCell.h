#pragma once

#include "PalpateIOModule.h"

#include <string>

namespace palpate
{
/// A text as a cell of a table that no spreadsheet takes for a formula: where it begins with
/// = + - @, a tab or a carriage return and is no number, or with apostrophes before these, it gets
/// an apostrophe in front.
PALPATEIO_EXPORT std::string InertCell(const std::string& text);

/// The text that InertCell was given.
PALPATEIO_EXPORT std::string TextOfCell(const std::string& cell);
} // namespace palpate
