#pragma once

#include "PalpateStudyModule.h"
#include "StudyState.h"

#include <filesystem>

namespace palpate
{
/// Which structure is brought onto which, and a volume that goes with it.
struct MatchChoice
{
  int MovingId = 0;
  int FixedId = 0;
  int VolumeId = 0; ///< a further volume; 0: none
};

/// Writes the transform that brings the moving structure where `map` (world, mm, from where it is
/// now) has it, from where its file has it; and returns the state in which it is there by that
/// file, with the volume, and all structures of the same files that were moved as it. Throws
/// InputError if the volume was moved otherwise, for FLIRT's matrices where these files are no
/// images of one grid, and as WriteTransform does.
PALPATESTUDY_EXPORT StudyState WriteMatch(const StudyState& state, const MatchChoice& choice,
                                          const Eigen::Affine3d& map,
                                          const std::filesystem::path& file);
} // namespace palpate
