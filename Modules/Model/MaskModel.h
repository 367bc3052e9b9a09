#pragma once

#include "IndexToWorld.h"
#include "OrganModel.h"
#include "Status.h"
#include "TopologyReport.h"
#include "VoxelMask.h"

namespace palpate
{
struct MaskModelSettings
{
  int Degree = 20;
  bool IsRadial = false; ///< a radius around the volume's centroid, else three coordinates
  /// Radial models of which more of the surface is hidden from the centre are refused.
  double MaximumHiddenPercent = 10.0;
};

/// Fits a model to a mask: a closed surface without handles in world mm, then the
/// surface model of MakeMappedSurface, or radii along 4,002 directions. A surface model takes in
/// parts that are near the largest; others are left out. Fails as the steps do, for a mask without
/// voxels, where too much is hidden, and beyond the limits of CheckTopology, for which the parts
/// that are left out count too. `changes`, if not null, gets what the model leaves out, fills or
/// cuts.
Status FitMask(VoxelMask mask, const IndexToWorld& toWorld, const MaskModelSettings& settings,
               OrganModel& model, TopologyReport* changes = nullptr);
} // namespace palpate
