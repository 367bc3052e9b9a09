#pragma once

#include "PalpateDisplayModule.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkLookupTable;

namespace palpate
{
/// Colours for an array whose numbers lie between `low` and `high`: diverging around zero where it
/// has both signs, and from white on otherwise. Its range is rounded to what reads well.
PALPATEDISPLAY_EXPORT vtkSmartPointer<vtkLookupTable> MakeArrayColors(double low, double high);

/// What stands over the colour bar of an array. Arrays of our own are lengths and say so; of others
/// the unit is not known, and the name is all there is.
PALPATEDISPLAY_EXPORT std::string ArrayTitle(const std::string& array);
} // namespace palpate
