#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// A place (mm, LPS) in a note: "(1.0, -2.0, 3.0)".
PALPATEFIT_EXPORT std::string PlaceText(const Vector3& placeWorld);

/// "0.345 mm³", "2101 mm³".
PALPATEFIT_EXPORT std::string VolumeText(double volume);

/// Adds a note on each kind of change that the repair of a structure's topology has made, with the
/// place of the largest.
PALPATEFIT_EXPORT void RemarkOnChanges(const TopologyReport& report, FitResult& result);
} // namespace palpate
