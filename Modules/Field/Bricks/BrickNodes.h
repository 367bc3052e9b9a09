#pragma once

#include "BrickLayout.h"
#include "FieldSamples.h"

#include <vector>

namespace palpate
{
/// Copies the nodes of bricks out of samples.
class BrickNodes
{
public:
  BrickNodes(const BrickLayout& layout, const FieldSamples& samples);

  /// The nodes of brick (i, j, k), i fastest. Beyond the grid there is what lies before its border,
  /// one node mirrored and then the last one again and again.
  void Gather(int i, int j, int k);
  const double* Values() const noexcept { return this->Nodes.data(); }
  /// A value among them: theirs where all are the same.
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
  std::array<std::array<int, LongestSide>, 3> Indices{}; ///< within the samples' box, -1 outside
  std::vector<double> Nodes;
  double Minimum = 0.0;
  double Maximum = 0.0;
};
} // namespace palpate
