#pragma once

#include "FitSettings.h"
#include "PalpateFitModule.h"
#include "Segmentation.h"

#include <string>
#include <vector>

namespace palpate
{
/// A structure to fit, and with which settings.
struct StructureToFit
{
  Segment Structure;
  FitSettings Settings;
};

/// The connected parts of a structure (--component each), by decreasing size, each with its own
/// component and a name of its own: "left" and "right" before the structure's name where two parts
/// lie beside each other in a file that states the patient's axes, otherwise "part 1", "part 2" and
/// so on. Parts below the size that a repair drops (TopologySettings::SmallPart), or of too few
/// voxels, are left out with a note in `leftOut`. A structure of one part is itself.
PALPATEFIT_EXPORT std::vector<StructureToFit> PartsOf(const Segmentation& segmentation,
                                                      const Segment& structure,
                                                      const FitSettings& settings,
                                                      std::string& leftOut);
} // namespace palpate
