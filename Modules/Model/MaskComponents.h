#pragma once

#include "RunComponents.h"
#include "VoxelMask.h"

#include <vector>

namespace palpate
{
/// Connected components of a mask: voxels that share a face are connected, as are the surfaces
/// around them.
class MaskComponents
{
public:
  explicit MaskComponents(const VoxelMask& mask);

  /// Voxels of each component, in descending order.
  const std::vector<long long>& VoxelCounts() const noexcept { return this->Counts; }

  /// Keeps the component of this rank (0 is the largest) in `mask` and clears the others.
  void Keep(int rank, VoxelMask& mask) const;

private:
  RunSet Runs;
  std::vector<int> Ranks; ///< of each run's component
  std::vector<long long> Counts;
};

/// Empty regions that a mask encloses: outside voxels that no path over faces, edges or corners of
/// outside voxels connects to the border of the box (which must be empty).
struct MaskCavities
{
  int Count = 0;
  long long Voxels = 0;
  long long LargestVoxels = 0;
};

MaskCavities FillCavities(VoxelMask& mask);
} // namespace palpate
