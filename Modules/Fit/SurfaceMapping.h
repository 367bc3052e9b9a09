#pragma once

#include "FitStages.h"

namespace palpate
{
/// Whether a radial model of the component leaves out more of the label than a repair may change.
bool LeavesOutParts(const FitResult& result);

/// Maps the largest component with the parts near it to the parameter sphere, as masks of thin
/// structures often have: voxels that touch by an edge, or slices that do not overlap. Returns
/// whether it did, or refused the structure because its parts are too far apart and the largest
/// alone leaves out too much (LeavesOutParts). False if it was tried before or there is nothing to
/// take in.
bool MapWithItsParts(FitSamples& made, const ProgressFunction& progress);

/// Maps the structure to the parameter sphere: with the parts near it, or else its component alone.
void MapStructure(FitSamples& made, const ProgressFunction& progress);
} // namespace palpate
