#include "SliceInterpolation.h"

#include "DistanceTransform.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double PartOfDepth = 1.0 / 3.0; // a small object is in few slices, which it is to follow
constexpr double Far = 2.0;               // depths: as far from a wall as slices without the object
} // namespace

SliceInterpolation::SliceInterpolation(const std::vector<float>& distances,
                                       const std::array<int, 3>& size, std::size_t across,
                                       double bound)
    : Size(size), Across(across)
{
  const double depth = *std::max_element(distances.begin(), distances.end());
  const double shallow = PartOfDepth * depth;
  this->Near = BoundedDistances(distances, std::min(bound, shallow));
  if (shallow < bound)
  {
    return;
  }
  this->Distances = BoundedDistances(distances, Far * depth);
  this->IsSmooth = this->SharesOfSmooth(bound);
  if (*std::max_element(this->IsSmooth.begin(), this->IsSmooth.end()) <= 0.0F)
  {
    this->Distances.clear();
    this->IsSmooth.clear();
  }
}

// From a voxel to that in the next slice.
std::size_t SliceInterpolation::Stride() const noexcept
{
  std::size_t stride = 1;
  for (std::size_t axis = 0; axis < this->Across; ++axis)
  {
    stride *= static_cast<std::size_t>(this->Size[axis]);
  }
  return stride;
}

// 1 where second differences over the seven slices around, which are all that polynomials next to a
// slice meet, are no more than the bound, 0 from twice the bound on. Polynomials overshoot by less
// than a tenth of them.
std::vector<float> SliceInterpolation::SharesOfSmooth(double bound) const
{
  constexpr std::size_t Reach = 3;
  const auto slices = static_cast<std::size_t>(this->Size[this->Across]);
  const std::size_t stride = this->Stride();
  const auto most = static_cast<float>(bound);
  std::vector<float> shares(this->Distances.size(), 0.0F);
  for (std::size_t at = 0; at < shares.size(); ++at)
  {
    const std::size_t slice = at / stride % slices;
    if (slice >= Reach && slice + Reach < slices)
    {
      float largest = 0.0F;
      const float* middle = &this->Distances[at - (Reach - 1) * stride];
      for (std::size_t n = 1; n < 2 * Reach; ++n, middle += stride)
      {
        largest = std::max(largest, std::abs(middle[stride] - 2.0F * *middle + *(middle - stride)));
      }
      shares[at] = std::clamp(2.0F - largest / most, 0.0F, 1.0F);
    }
  }
  return shares;
}

void SliceInterpolation::Resample(const AxisWeights& weights, std::size_t axis)
{
  const std::array<int, 3> before = this->Size;
  for (std::vector<float>* values : {&this->Near, &this->Distances, &this->IsSmooth})
  {
    std::array<int, 3> size = before;
    if (!values->empty())
    {
      *values = weights.Apply(*values, size, axis);
      this->Size = size;
    }
  }
}

std::vector<float> SliceInterpolation::PartBetween(const AxisNodes& nodes) const
{
  using Interpolation = AxisWeights::Interpolation;
  const auto sampled = [&](const std::vector<float>& values, Interpolation between)
  {
    std::array<int, 3> size = this->Size;
    return AxisWeights(nodes, between).Apply(values, size, this->Across);
  };
  std::vector<float> values = sampled(this->Near, Interpolation::Cubic);
  if (!this->IsSmooth.empty())
  {
    const std::vector<float> shares = sampled(this->IsSmooth, Interpolation::Linear);
    const std::vector<float> smooth = sampled(this->Distances, Interpolation::Quintic);
    for (std::size_t at = 0; at < values.size(); ++at)
    {
      values[at] += shares[at] * (smooth[at] - values[at]);
    }
  }
  return values;
}

// Some nodes at a time, to keep memory that of the result.
std::vector<float> SliceInterpolation::Between(const AxisNodes& nodes) const
{
  constexpr int AtATime = 8;
  const std::size_t stride = this->Stride();
  const auto slices = static_cast<std::size_t>(this->Size[this->Across]);
  const auto count = static_cast<std::size_t>(nodes.Count);
  std::vector<float> result(this->Near.size() / slices * count);
  for (int first = 0; first < nodes.Count; first += AtATime)
  {
    AxisNodes some = nodes;
    some.First += first * nodes.Step;
    some.Count = std::min(AtATime, nodes.Count - first);
    const std::vector<float> part = this->PartBetween(some);
    const std::size_t row = stride * static_cast<std::size_t>(some.Count);
    for (std::size_t block = 0; block * row < part.size(); ++block)
    {
      std::copy_n(&part[block * row], row,
                  &result[(block * count + static_cast<std::size_t>(first)) * stride]);
    }
  }
  return result;
}
} // namespace palpate
