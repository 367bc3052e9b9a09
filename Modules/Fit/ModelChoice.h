#pragma once

#include "FitResult.h"

#include <string>

namespace palpate
{
/// How ModelKind::Automatic chooses between a radial and a surface model of a structure that the
/// centre sees. Distances are the largest and that which 95 % of model and mask stay below, against
/// the largest side of a voxel.

/// Whether a surface model may be chosen; not where a radial one is wanted whatever it loses.
bool MayTakeSurfaceModel(const FitSettings& settings);

/// Whether a surface model is worth its time: the radial model is refused, misses the tolerance,
/// has another volume, lies farther from the mask than its voxels explain, or is elongated.
bool IsDoubtful(const FitResult& radial);

/// A surface model takes the place of a doubtful radial one if it is clearly nearer to the mask, or
/// if both are refused and it has a way out.
bool IsBetter(const FitResult& surface, const FitResult& radial);

/// A note on which of two models was taken, and why; empty if one of them was refused.
std::string ReasonOfChoice(const FitResult& surface, const FitResult& radial);
} // namespace palpate
