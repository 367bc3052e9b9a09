#include "SliceInterpolation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t Reach = 3; // slices on both sides: all that a node's polynomial meets
constexpr double PartOfDepth = 1.0 / 3.0; // a small object is in few slices, which it is to follow

std::vector<float> Bounded(std::vector<float> values, double bound)
{
  const auto most = static_cast<float>(bound);
  for (float& value : values)
  {
    value = std::clamp(value, -most, most);
  }
  return values;
}

// From a voxel to that in the next slice.
std::size_t StrideOf(const std::array<int, 3>& size, std::size_t across)
{
  std::size_t stride = 1;
  for (std::size_t axis = 0; axis < across; ++axis)
  {
    stride *= static_cast<std::size_t>(size[axis]);
  }
  return stride;
}
} // namespace

SliceInterpolation::SliceInterpolation(std::size_t across, const AxisNodes& nodes)
    : Across(across), Nodes(nodes)
{
}

std::vector<float> SliceInterpolation::Sampled(const std::vector<float>& values,
                                               AxisWeights::Interpolation between,
                                               std::array<int, 3>& size) const
{
  return AxisWeights(this->Nodes, between).Apply(values, size, this->Across);
}

// Of each voxel: 1 where the distances of the seven slices around are less than half the depth, 0
// where one is the depth.
std::vector<float> SliceInterpolation::SharesNearWall(const std::vector<float>& distances,
                                                      double depth,
                                                      const std::array<int, 3>& size) const
{
  const auto slices = static_cast<std::size_t>(size[this->Across]);
  const std::size_t stride = StrideOf(size, this->Across);
  const auto perDepth = static_cast<float>(2.0 / depth);
  std::vector<float> shares(distances.size(), 0.0F);
  for (std::size_t at = 0; at < distances.size(); ++at)
  {
    const std::size_t slice = at / stride % slices;
    if (slice >= Reach && slice + Reach < slices)
    {
      float farthest = 0.0F;
      for (std::size_t n = 0; n <= 2 * Reach; ++n)
      {
        farthest = std::max(farthest, std::abs(distances[at + n * stride - Reach * stride]));
      }
      shares[at] = std::clamp(2.0F - perDepth * farthest, 0.0F, 1.0F);
    }
  }
  return shares;
}

std::vector<float> SliceInterpolation::Apply(const std::vector<float>& distances, double bound,
                                             std::array<int, 3>& size) const
{
  using Interpolation = AxisWeights::Interpolation;
  const double depth = *std::max_element(distances.begin(), distances.end());
  std::array<int, 3> sizeNear = size;
  std::array<int, 3> sizeOfShares = size;
  std::vector<float> shares = this->SharesNearWall(distances, depth, size);
  std::vector<float> values = this->Sampled(
      Bounded(distances, std::min(bound, PartOfDepth * depth)), Interpolation::Cubic, size);
  if (*std::max_element(shares.begin(), shares.end()) > 0.0F)
  {
    shares = this->Sampled(shares, Interpolation::Linear, sizeOfShares);
    const std::vector<float> near = this->Sampled(distances, Interpolation::Quintic, sizeNear);
    for (std::size_t at = 0; at < values.size(); ++at)
    {
      values[at] += shares[at] * (near[at] - values[at]);
    }
  }
  return values;
}
} // namespace palpate
