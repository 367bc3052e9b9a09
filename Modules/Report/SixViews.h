#pragma once

#include "PalpateReportModule.h"

#include <string>

class vtkLookupTable;

namespace palpate
{
class SoftwareRenderer;

/// A surface from six sides as HTML, with letters for the patient's sides.
PALPATEREPORT_EXPORT std::string SixViews(const SoftwareRenderer& renderer);

/// A bar of colours for numbers on both sides of zero, as HTML, from minus to plus the end of their
/// range; with plain texts over its low end, its middle and its high end.
PALPATEREPORT_EXPORT std::string DivergingColorBar(vtkLookupTable* colors, const std::string& low,
                                                   const std::string& unit,
                                                   const std::string& high);
} // namespace palpate
