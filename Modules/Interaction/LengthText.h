#pragma once

#include "PalpateInteractionModule.h"

#include <string>

namespace palpate
{
/// "12.5 mm": with so many decimals, whatever the locale.
PALPATEINTERACTION_EXPORT std::string LengthText(double millimeters, int decimals);
} // namespace palpate
