#pragma once

#include "PalpateIOModule.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// Millimetres per unit of a length: "mm", "um" (also with a micro sign, "micron"), "nm", "cm",
/// "m", "in", or their English names, in any case. Nothing for another text.
PALPATEIO_EXPORT std::optional<double> MillimetersPer(const std::string& unit);

/// The entries of a list of units, `"mm" "mm" "mm"`, without their quotes, of which an entry may be
/// empty.
PALPATEIO_EXPORT std::vector<std::string> ListedUnits(const std::string& text);
} // namespace palpate
