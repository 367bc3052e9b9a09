#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// Samples of a scalar field on a regular grid parallel to an image's axes.
struct ScalarGrid
{
  std::array<double, 3> StartIndex{}; ///< of the first sample, from the image's first voxel
  std::array<double, 3> StepIndex{};  ///< in image voxels
  std::array<double, 3> Spacing{};    ///< the same step in mm
  std::array<int, 3> Size{};          ///< samples along i, j, k
  std::vector<float> Values;          ///< i runs fastest

  std::size_t SliceStride(int axis) const noexcept
  {
    std::size_t stride = 1;
    for (int a = 0; a < axis; ++a)
    {
      stride *= static_cast<std::size_t>(this->Size[static_cast<std::size_t>(a)]);
    }
    return stride;
  }
};
} // namespace palpate
