#pragma once

#include "PalpateDisplayModule.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkLookupTable;

namespace palpate
{
/// Colours for an array with values between `low` and `high`: diverging around zero if it has both
/// signs, otherwise starting at white. The range is rounded to convenient numbers.
PALPATEDISPLAY_EXPORT vtkSmartPointer<vtkLookupTable> MakeArrayColors(double low, double high);

/// Title of an array's colour bar. Palpate's own arrays are lengths, with a unit; for others the
/// unit is unknown, and the title is the name.
PALPATEDISPLAY_EXPORT std::string ArrayTitle(const std::string& array);
} // namespace palpate
