#pragma once

#include "NodeBox.h"
#include "RemovedDistances.h"

#include <array>
#include <vector>

namespace palpate
{
/// Distances to what was removed at nodes side by side, as they count for interpolation: each
/// corrected by its six neighbours (InterpolatedDistance). Across the grid's border they go on
/// straight. Kept as one object, so that it allocates for the largest box alone.
class DistanceBox
{
public:
  /// Of nodes of the grid. False where nothing is removed within the band of any of them, or of a
  /// neighbour; then all are as far away as the band is wide.
  bool Gather(const RemovedDistances& removed, const NodeBox& box);

  /// Of the box's nodes from (i, j, k) on along i.
  const float* Row(int i, int j, int k) const noexcept
  {
    const int row = (k - this->Box.First[2]) * this->Count[1] + j - this->Box.First[1];
    return &this->Corrected[static_cast<std::size_t>(row * this->Count[0] + i -
                                                     this->Box.First[0])];
  }

private:
  bool Copy(const RemovedDistances& removed);
  void CopyBlock(const float* block, float same, const std::array<int, 3>& corner,
                 const NodeBox& nodes);
  void ContinueBeyond(const std::array<int, 3>& nodes);
  void Continue(std::size_t axis, bool isUpper);
  void Correct();
  std::size_t RawNumber(const std::array<int, 3>& at) const noexcept
  {
    const auto row = static_cast<std::size_t>(this->Count[0] + 2);
    const auto rows = static_cast<std::size_t>(this->Count[1] + 2);
    return (static_cast<std::size_t>(at[2]) * rows + static_cast<std::size_t>(at[1])) * row +
           static_cast<std::size_t>(at[0]);
  }

  NodeBox Box;
  std::array<int, 3> Count{};
  std::vector<float> Raw; // one node more on each side
  std::vector<float> Corrected;
};
} // namespace palpate
