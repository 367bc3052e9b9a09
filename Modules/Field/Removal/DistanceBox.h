#pragma once

#include "NodeBox.h"
#include "RemovedDistances.h"

#include <array>
#include <vector>

namespace palpate
{
/// Distances to the removed volume at a box of nodes, as used for interpolation: each corrected by
/// its six neighbours (InterpolatedDistance). Extrapolated linearly across the grid's border. Reuse
/// one object: it then allocates for the largest box only.
class DistanceBox
{
public:
  /// Gathers nodes of the grid. Returns false if nothing is removed within the band of any of them,
  /// or of a neighbour; then all distances equal the band.
  bool Gather(const RemovedDistances& removed, const NodeBox& box);

  /// Row of the box's nodes along i, starting at (i, j, k).
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
