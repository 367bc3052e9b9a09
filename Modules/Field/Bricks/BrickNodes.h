#pragma once

#include "BrickLayout.h"
#include "FieldSamples.h"

#include <vector>

namespace palpate
{
/// Gathers the nodes of bricks from samples.
class BrickNodes
{
public:
  BrickNodes(const BrickLayout& layout, const FieldSamples& samples);

  /// The nodes of brick (i, j, k), i fastest. Beyond the grid, the first node is the mirrored one,
  /// and the border node is repeated after that.
  void Gather(int i, int j, int k);
  const double* Values() const noexcept { return this->Nodes.data(); }
  /// The middle of the range of values: exact if all are the same.
  float Middle() const noexcept
  {
    return static_cast<float>(this->Minimum + 0.5 * (this->Maximum - this->Minimum));
  }
  double Lowest() const noexcept { return this->Minimum; }
  double Highest() const noexcept { return this->Maximum; }

private:
  bool IsOutside(int i, int j, int k) const;
  void FillIndices(std::size_t axis, int brick);
  template <typename T>
  void CopyNodes(const T* data);

  BrickLayout Layout;
  FieldSamples Samples;
  static constexpr std::size_t LongestSide = BrickLayout::Cells + 3;
  std::array<std::array<int, LongestSide>, 3> Indices{}; ///< within the samples' box; -1 outside
  std::vector<double> Nodes;
  double Minimum = 0.0;
  double Maximum = 0.0;
};
} // namespace palpate
