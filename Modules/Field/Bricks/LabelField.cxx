#include "LabelField.h"

#include "DistanceTransform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace palpate
{
namespace
{
// Directions and range of the distances.
struct DistanceRule
{
  DistanceDomain Domain = DistanceDomain::Space;
  double CutOff = 0.0;               ///< mm
  double HalfStep = 0.0;             ///< from a voxel centre to the boundary
  std::array<double, 3> Deviation{}; ///< of the smoothing, in voxels
  std::array<int, 3> Reach{};        ///< of cut-off and smoothing together, in voxels
};

constexpr double WidestSmoothing = 8.0;
constexpr double KernelReach = 3.0; // in standard deviations

DistanceRule RuleFor(const FieldGrid& grid, double smoothing)
{
  constexpr double ThickSlices = 1.5;
  constexpr double VoxelsInSpace = 4.0;
  const Vector3& spacing = grid.Spacing();
  int coarsest = 0;
  spacing.maxCoeff(&coarsest);
  const double others = std::max(spacing[(coarsest + 1) % 3], spacing[(coarsest + 2) % 3]);
  DistanceRule rule;
  const bool isThick = spacing[coarsest] >= ThickSlices * others;
  rule.Domain = isThick ? static_cast<DistanceDomain>(coarsest) : DistanceDomain::Space;
  rule.CutOff = isThick ? spacing[coarsest] : VoxelsInSpace * spacing[coarsest];
  // The smallest step: with a longer one, centres near the boundary would change sides. Equal on
  // both sides, it puts the boundary half way along every axis.
  rule.HalfStep = 0.5 * spacing.minCoeff();
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    const bool isWithinSlices = !isThick || axis != coarsest;
    rule.Deviation[a] = smoothing * spacing.minCoeff() / spacing[axis];
    const double distance = isWithinSlices ? (rule.CutOff + rule.HalfStep) / spacing[axis] : 0.0;
    rule.Reach[a] = static_cast<int>(std::ceil(distance + KernelReach * rule.Deviation[a])) + 1;
  }
  return rule;
}

template <typename T>
bool CanHold(long long label)
{
  return label < 0 ? std::numeric_limits<T>::is_signed &&
                         label >= static_cast<long long>(std::numeric_limits<T>::min())
                   : static_cast<unsigned long long>(label) <=
                         static_cast<unsigned long long>(std::numeric_limits<T>::max());
}

template <typename T>
bool CutOutLabel(const T* labels, const FieldGrid& grid, long long label,
                 const std::array<int, 3>& rim, VoxelMask& mask)
{
  if constexpr (std::is_integral_v<T>)
  {
    if (!CanHold<T>(label))
    {
      return false;
    }
    const std::array<int, 3>& size = grid.Size();
    LabelBounds bounds = FindLabelBounds(labels, size, static_cast<T>(label));
    if (bounds.IsEmpty())
    {
      return false;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      bounds.First[axis] = std::max(bounds.First[axis] - rim[axis], 0);
      bounds.Last[axis] = std::min(bounds.Last[axis] + rim[axis], size[axis] - 1);
    }
    const Vector3& spacing = grid.Spacing();
    mask = CopyLabel(labels, size, {spacing[0], spacing[1], spacing[2]}, bounds,
                     static_cast<T>(label));
    return true;
  }
  return false;
}

std::vector<float> ClampedDistances(const VoxelMask& mask, const DistanceRule& rule)
{
  std::vector<float> distances = SignedDistance(mask, rule.Domain, rule.HalfStep);
  const auto cutOff = static_cast<float>(rule.CutOff);
  for (float& distance : distances)
  {
    distance = std::clamp(distance, -cutOff, cutOff);
  }
  return distances;
}

// Weights of a Gaussian, starting at its centre; together with their mirror images they sum to one.
std::vector<float> GaussianWeights(double deviation)
{
  std::vector<float> weights{1.0f};
  float sum = 1.0f;
  for (int n = 1; n <= std::ceil(KernelReach * deviation) && deviation > 0.0; ++n)
  {
    weights.push_back(static_cast<float>(std::exp(-0.5 * n * n / (deviation * deviation))));
    sum += 2.0f * weights.back();
  }
  for (float& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

// Along one axis; beyond the box the outermost values are repeated.
void Smooth(const VoxelMask& mask, std::size_t axis, double deviation, std::vector<float>& values)
{
  const std::vector<float> weights = GaussianWeights(deviation);
  const std::vector<float> before = values;
  const int last = mask.Size[axis] - 1;
  std::array<int, 3> at{};
  for (at[2] = 0; at[2] < mask.Size[2]; ++at[2])
  {
    for (at[1] = 0; at[1] < mask.Size[1]; ++at[1])
    {
      for (at[0] = 0; at[0] < mask.Size[0]; ++at[0])
      {
        const std::size_t offset = mask.Offset(at[0], at[1], at[2]);
        float sum = weights[0] * before[offset];
        std::array<int, 3> low = at;
        std::array<int, 3> high = at;
        for (std::size_t n = 1; n < weights.size(); ++n)
        {
          low[axis] = std::max(at[axis] - static_cast<int>(n), 0);
          high[axis] = std::min(at[axis] + static_cast<int>(n), last);
          sum += weights[n] * (before[mask.Offset(low[0], low[1], low[2])] +
                               before[mask.Offset(high[0], high[1], high[2])]);
        }
        values[offset] = sum;
      }
    }
  }
}
std::vector<float> SmoothedBy(const DistanceRule& rule, const VoxelMask& mask,
                              const std::vector<float>& distances)
{
  std::vector<float> smoothed = distances;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (rule.Deviation[axis] > 0.0)
    {
      Smooth(mask, axis, rule.Deviation[axis], smoothed);
    }
  }
  return smoothed;
}

std::ptrdiff_t InsideCount(const std::vector<float>& distances)
{
  return std::count_if(distances.begin(), distances.end(),
                       [](float distance) { return distance > 0.0f; });
}

// Voxels; less than this leaves the voxels' steps as they are.
constexpr double LeastSmoothing = 0.2;
} // namespace

Status LabelField::Make(const FieldSamples& labels, const FieldGrid& grid, long long label,
                        double smoothing, LabelField& field)
{
  Status status = grid.Check();
  if (!status.IsOk())
  {
    return status;
  }
  if (labels.Data == nullptr || labels.Type == ScalarType::Float32 ||
      labels.Type == ScalarType::Float64 || labels.Count() != grid.NodeCount())
  {
    return Status::Failure("A label map must have one integer for every voxel of the grid.");
  }
  if (!(smoothing >= 0.0 && smoothing <= WidestSmoothing))
  {
    return Status::Failure("A label field's smoothing must be between 0 and 8 voxels.");
  }
  const DistanceRule rule = RuleFor(grid, smoothing);
  VoxelMask mask;
  const bool isThere = VisitScalars(labels.Data, labels.Type,
                                    [&](const auto* data)
                                    { return CutOutLabel(data, grid, label, rule.Reach, mask); });
  if (!isThere)
  {
    return Status::Failure("No voxel has the label " + std::to_string(label) + ".");
  }
  const std::vector<float> distances = ClampedDistances(mask, rule);
  const auto least = InsideCount(distances) / 2;
  field.Smoothed = smoothing;
  field.Distances = SmoothedBy(RuleFor(grid, smoothing), mask, distances);
  while (InsideCount(field.Distances) < least)
  {
    field.Smoothed = field.Smoothed > LeastSmoothing ? 0.5 * field.Smoothed : 0.0;
    field.Distances = SmoothedBy(RuleFor(grid, field.Smoothed), mask, distances);
  }
  field.StartIndex = mask.StartIndex;
  field.Size = mask.Size;
  field.CutOff = static_cast<float>(rule.CutOff);
  return Status::Success();
}

FieldSamples LabelField::Samples() const noexcept
{
  return {this->Distances.data(), ScalarType::Float32, this->StartIndex, this->Size,
          -static_cast<double>(this->CutOff)};
}
} // namespace palpate
