#pragma once

#include "PalpateDisplayModule.h"

#include "vtkLookupTable.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <string>

namespace palpate
{
/// Colours for an array with values between `low` and `high`: blue below zero, nearly white at
/// zero, red above. The range is symmetric if it has both signs, otherwise it ends at zero; it is
/// rounded up to 1, 1.5, 2, 3, 4, 5, 6 or 8 times a power of ten. Blue and red are distinguishable
/// for colour-blind viewers, and lightness decreases evenly to both sides: linear interpolation in
/// CIELAB between the ends and the centre of ColorBrewer's RdBu scheme (Harrower and Brewer, The
/// Cartographic Journal 40, 2003).
PALPATEDISPLAY_EXPORT vtkSmartPointer<vtkLookupTable> MakeArrayColors(double low, double high);

/// sRGB; beyond the range the colour of its end, grey for a number that is not finite.
PALPATEDISPLAY_EXPORT std::array<std::uint8_t, 3> ColorOf(vtkLookupTable* colors, double number);

/// Title of an array's colour bar, with the unit of Palpate's own arrays; for others the unit is
/// unknown, and the title is the name.
PALPATEDISPLAY_EXPORT std::string ArrayTitle(const std::string& array);
} // namespace palpate
