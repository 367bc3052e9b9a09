#pragma once

#include "PalpateReportModule.h"

#include "SoftwareRenderer.h"
#include "Vector3.h"

#include <string>

class vtkLookupTable;

namespace palpate
{
class ReportPage;

/// The letters of the patient's sides at the four edges of an image of this size, as SVG.
PALPATEREPORT_EXPORT std::string SideLetters(double width, double height, const Vector3& rightWorld,
                                             const Vector3& downWorld);

/// Adds a surface from six sides, with letters for the patient's sides.
PALPATEREPORT_EXPORT void AddSixViews(ReportPage& page, const SoftwareRenderer& renderer);

/// Adds a bar of colours for numbers on both sides of zero, from minus to plus the end of their
/// range; with plain texts over its low end, its middle and its high end.
PALPATEREPORT_EXPORT void AddColorBar(ReportPage& page, vtkLookupTable* colors,
                                      const std::string& low, const std::string& unit,
                                      const std::string& high);
} // namespace palpate
