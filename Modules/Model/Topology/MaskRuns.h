#pragma once

#include "RunComponents.h"
#include "VoxelMask.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{
/// The voxels of a mask as runs, in its own indices.
RunSet RunsOf(const VoxelMask& mask);

/// Sets the voxels of the runs for whose indices `isWanted` to `value`.
template <typename Predicate>
void SetRuns(const RunSet& runs, const Predicate& isWanted, unsigned char value, VoxelMask& mask)
{
  for (std::size_t row = 0; row < runs.Rows().size(); ++row)
  {
    unsigned char* const voxels =
        mask.Inside.data() + mask.Offset(0, runs.Rows()[row].Y, runs.Rows()[row].Z);
    for (std::size_t run = runs.Rows()[row].Start; run < runs.RowEnd(row); ++run)
    {
      if (isWanted(run))
      {
        std::fill(voxels + runs.Runs()[run].First, voxels + runs.Runs()[run].End, value);
      }
    }
  }
}
} // namespace palpate
