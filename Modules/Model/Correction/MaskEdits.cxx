#include "MaskEdits.h"

#include "DistanceTransform.h"
#include "MaskComponents.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace palpate
{
namespace
{
constexpr double GaussianReach = 3.0; // standard deviations

std::vector<float> GaussianWeights(double deviation)
{
  const int reach = static_cast<int>(std::ceil(GaussianReach * deviation));
  std::vector<float> weights;
  float sum = 0.0f;
  for (int n = -reach; n <= reach; ++n)
  {
    weights.push_back(static_cast<float>(std::exp(-0.5 * n * n / (deviation * deviation))));
    sum += weights.back();
  }
  for (float& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

// Blurs one line of a field, which goes on with its last value at both ends.
void BlurLine(const std::vector<float>& weights, float* first, std::size_t stride,
              std::vector<float>& line)
{
  const auto count = static_cast<std::ptrdiff_t>(line.size());
  const auto reach = static_cast<std::ptrdiff_t>(weights.size() / 2);
  for (std::ptrdiff_t n = 0; n < count; ++n)
  {
    line[static_cast<std::size_t>(n)] = first[static_cast<std::size_t>(n) * stride];
  }
  for (std::ptrdiff_t n = 0; n < count; ++n)
  {
    float sum = 0.0f;
    for (std::ptrdiff_t by = -reach; by <= reach; ++by)
    {
      const std::ptrdiff_t from = std::clamp<std::ptrdiff_t>(n + by, 0, count - 1);
      sum += weights[static_cast<std::size_t>(by + reach)] * line[static_cast<std::size_t>(from)];
    }
    first[static_cast<std::size_t>(n) * stride] = sum;
  }
}

void BlurField(double deviation, const VoxelMask& grid, std::vector<float>& field)
{
  const std::array<std::size_t, 3> strides{1, grid.Offset(0, 1, 0), grid.Offset(0, 0, 1)};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<float> weights = GaussianWeights(deviation / grid.Spacing[axis]);
    std::vector<float> line(static_cast<std::size_t>(grid.Size[axis]));
    const std::size_t second = axis == 0 ? 1 : 0;
    const std::size_t third = axis == 2 ? 1 : 2;
    for (int k = 0; k < grid.Size[third]; ++k)
    {
      for (int j = 0; j < grid.Size[second]; ++j)
      {
        BlurLine(weights,
                 &field[static_cast<std::size_t>(k) * strides[third] +
                        static_cast<std::size_t>(j) * strides[second]],
                 strides[axis], line);
      }
    }
  }
}
} // namespace

VoxelMask InBox(const VoxelMask& mask, const std::array<int, 3>& first,
                const std::array<int, 3>& last)
{
  VoxelMask boxed;
  boxed.StartIndex = first;
  boxed.Spacing = mask.Spacing;
  std::array<int, 3> from{}; // of the mask's box
  std::array<int, 3> count{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    boxed.Size[axis] = last[axis] - first[axis] + 1;
    from[axis] = std::max(first[axis] - mask.StartIndex[axis], 0);
    const int end = std::min(last[axis] + 1 - mask.StartIndex[axis], mask.Size[axis]);
    count[axis] = std::max(end - from[axis], 0);
  }
  boxed.Inside.assign(boxed.Offset(0, 0, boxed.Size[2]), 0);
  const auto to = [&](std::size_t axis)
  { return from[axis] + mask.StartIndex[axis] - first[axis]; };
  for (int k = 0; k < count[2] && count[0] > 0; ++k)
  {
    for (int j = 0; j < count[1]; ++j)
    {
      std::copy_n(&mask.Inside[mask.Offset(from[0], from[1] + j, from[2] + k)], count[0],
                  &boxed.Inside[boxed.Offset(to(0), to(1) + j, to(2) + k)]);
    }
  }
  return boxed;
}

bool HasVoxel(const VoxelMask& mask, const std::array<int, 3>& index) noexcept
{
  std::array<int, 3> at{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    at[axis] = index[axis] - mask.StartIndex[axis];
    if (at[axis] < 0 || at[axis] >= mask.Size[axis])
    {
      return false;
    }
  }
  return mask.Inside[mask.Offset(at[0], at[1], at[2])] != 0;
}

long long RemoveIslands(VoxelMask& mask)
{
  const MaskComponents parts(mask);
  const long long before = mask.Count();
  if (parts.VoxelCounts().size() > 1)
  {
    parts.Keep(0, mask);
  }
  return before - mask.Count();
}

void SmoothMask(double deviation, VoxelMask& mask)
{
  const auto count = static_cast<std::size_t>(mask.Count());
  if (count == 0 || !(deviation > 0.0))
  {
    return;
  }
  const double halfStep = 0.5 * *std::min_element(mask.Spacing.begin(), mask.Spacing.end());
  std::vector<float> field = SignedDistance(mask, DistanceDomain::Space, halfStep);
  BlurField(deviation, mask, field);
  std::vector<float> sorted = field;
  const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(count - 1);
  std::nth_element(sorted.begin(), last, sorted.end(), std::greater<>());
  std::transform(field.begin(), field.end(), mask.Inside.begin(),
                 [level = *last](float value) { return value >= level ? 1 : 0; });
}

void CutMask(const Vector3& pointWorld, const Vector3& normal, const IndexToWorld& toWorld,
             VoxelMask& mask)
{
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      for (int i = 0; i < mask.Size[0]; ++i)
      {
        const Vector3 index(mask.StartIndex[0] + i, mask.StartIndex[1] + j, mask.StartIndex[2] + k);
        if ((toWorld(index) - pointWorld).dot(normal) > 0.0)
        {
          mask.Inside[mask.Offset(i, j, k)] = 0;
        }
      }
    }
  }
}
} // namespace palpate
