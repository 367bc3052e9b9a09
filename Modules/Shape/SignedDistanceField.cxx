#include "SignedDistanceField.h"

#include "DistanceTransform.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int MaximumRefinement = 16;
constexpr double MaximumSamples = 6e7; // 240 MB of float: beyond, slices are refined less

ScalarGrid GridOf(const VoxelMask& mask)
{
  ScalarGrid grid;
  grid.Size = mask.Size;
  grid.Spacing = mask.Spacing;
  grid.StepIndex = {1.0, 1.0, 1.0};
  std::copy(mask.StartIndex.begin(), mask.StartIndex.end(), grid.StartIndex.begin());
  return grid;
}

// The mask with its axes permuted so that the coarsest is the third.
struct TurnedMask
{
  VoxelMask Mask;
  std::array<std::size_t, 3> Axes; // axis of the original that each axis of Mask was
};

std::size_t CoarsestAxis(const VoxelMask& mask)
{
  return static_cast<std::size_t>(std::max_element(mask.Spacing.begin(), mask.Spacing.end()) -
                                  mask.Spacing.begin());
}

TurnedMask TurnCoarsestLast(const VoxelMask& mask)
{
  const std::size_t axis = CoarsestAxis(mask);
  TurnedMask turned{{}, {(axis + 1) % 3, (axis + 2) % 3, axis}};
  for (std::size_t a = 0; a < 3; ++a)
  {
    turned.Mask.Size[a] = mask.Size[turned.Axes[a]];
    turned.Mask.Spacing[a] = mask.Spacing[turned.Axes[a]];
    turned.Mask.StartIndex[a] = mask.StartIndex[turned.Axes[a]];
  }
  turned.Mask.Inside.resize(mask.Inside.size());
  std::array<int, 3> at{};
  for (at[2] = 0; at[2] < mask.Size[2]; ++at[2])
  {
    for (at[1] = 0; at[1] < mask.Size[1]; ++at[1])
    {
      for (at[0] = 0; at[0] < mask.Size[0]; ++at[0])
      {
        turned.Mask.Inside[turned.Mask.Offset(at[turned.Axes[0]], at[turned.Axes[1]],
                                              at[turned.Axes[2]])] =
            mask.Inside[mask.Offset(at[0], at[1], at[2])];
      }
    }
  }
  return turned;
}

// Permutes a grid over a turned mask back to the original's axes.
ScalarGrid TurnBack(const ScalarGrid& turned, const std::array<std::size_t, 3>& axes)
{
  ScalarGrid grid;
  std::array<std::size_t, 3> stride{};
  for (std::size_t a = 0; a < 3; ++a)
  {
    grid.Size[axes[a]] = turned.Size[a];
    grid.Spacing[axes[a]] = turned.Spacing[a];
    grid.StepIndex[axes[a]] = turned.StepIndex[a];
    grid.StartIndex[axes[a]] = turned.StartIndex[a];
    stride[axes[a]] = turned.SliceStride(static_cast<int>(a));
  }
  grid.Values.resize(turned.Values.size());
  float* target = grid.Values.data();
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    for (int j = 0; j < grid.Size[1]; ++j)
    {
      const float* source = &turned.Values[static_cast<std::size_t>(k) * stride[2] +
                                           static_cast<std::size_t>(j) * stride[1]];
      for (int i = 0; i < grid.Size[0]; ++i, source += stride[0])
      {
        *target++ = *source;
      }
    }
  }
  return grid;
}

// Interpolates the slices of a signed in-plane distance along the third axis. The distance is
// clamped to one slice step: outlines that lie closer than that from slice to slice are joined by
// an oblique wall; where they lie further apart, or a slice is empty, the shape ends half way
// between the slices with a rounded edge, as in the mask itself. So the surface never crosses a
// line between voxel centres of one kind, and stays within half a step of the mask's own half
// level.
class SliceInterpolator
{
public:
  SliceInterpolator(const VoxelMask& mask, int refinement)
      : Mask(mask), Refinement(refinement), SliceSize(mask.Offset(0, 0, 1)),
        Field(SignedDistances(mask, DistanceDomain::AcrossK,
                              0.25 * (mask.Spacing[0] + mask.Spacing[1])))
  {
    const auto bound = static_cast<float>(mask.Spacing[2]);
    for (float& value : this->Field)
    {
      value = std::clamp(value, -bound, bound);
    }
  }

  ScalarGrid Run() const
  {
    ScalarGrid grid = GridOf(this->Mask);
    grid.Size[2] = (this->Mask.Size[2] - 1) * this->Refinement + 1;
    grid.StepIndex[2] = 1.0 / this->Refinement;
    grid.Spacing[2] /= this->Refinement;
    grid.Values.resize(this->SliceSize * static_cast<std::size_t>(grid.Size[2]));
    for (int k = 0; k + 1 < this->Mask.Size[2]; ++k)
    {
      const int steps = k + 2 == this->Mask.Size[2] ? this->Refinement + 1 : this->Refinement;
      for (int step = 0; step < steps; ++step)
      {
        const double t = static_cast<double>(step) / this->Refinement;
        float* target =
            &grid.Values[this->SliceSize * static_cast<std::size_t>(k * this->Refinement + step)];
        this->Between(k, t, target);
      }
    }
    return grid;
  }

private:
  const float* Slice(int k) const
  {
    return &this->Field[this->SliceSize * static_cast<std::size_t>(k)];
  }

  void Between(int k, double t, float* target) const
  {
    const float* low = this->Slice(k);
    const float* high = this->Slice(k + 1);
    const auto part = static_cast<float>(t);
    for (std::size_t at = 0; at < this->SliceSize; ++at)
    {
      target[at] = low[at] + part * (high[at] - low[at]);
    }
  }

  const VoxelMask& Mask;
  int Refinement;
  std::size_t SliceSize;
  std::vector<float> Field;
};

ScalarGrid InterpolateShape(const VoxelMask& mask)
{
  const TurnedMask turned = TurnCoarsestLast(mask);
  const std::array<double, 3>& spacing = turned.Mask.Spacing;
  const double wanted = std::round(spacing[2] / std::sqrt(spacing[0] * spacing[1]));
  const double affordable = MaximumSamples / static_cast<double>(mask.Inside.size());
  const int refinement = static_cast<int>(
      std::clamp(std::min(wanted, affordable), 1.0, static_cast<double>(MaximumRefinement)));
  return TurnBack(SliceInterpolator(turned.Mask, refinement).Run(), turned.Axes);
}

ScalarGrid DistanceInSpace(const VoxelMask& mask)
{
  ScalarGrid grid = GridOf(mask);
  const double meanSpacing = std::cbrt(mask.VoxelVolume());
  grid.Values = SignedDistances(mask, DistanceDomain::Space, 0.5 * meanSpacing);
  return grid;
}

ScalarGrid HalfLevel(const VoxelMask& mask)
{
  ScalarGrid grid = GridOf(mask);
  grid.Values.resize(mask.Inside.size());
  std::transform(mask.Inside.begin(), mask.Inside.end(), grid.Values.begin(),
                 [](unsigned char inside) { return inside != 0 ? 0.5f : -0.5f; });
  return grid;
}

// Converts a distance to the occupancy of a voxel minus one half: unlike a distance, it can be
// blurred without distant parts of the shape displacing the surface.
void ToOccupancy(ScalarGrid& grid, double width)
{
  const auto scale = static_cast<float>(1.0 / width);
  for (float& value : grid.Values)
  {
    value = std::clamp(value * scale, -0.5f, 0.5f);
  }
}

void Smooth(ScalarGrid& grid, double smoothing)
{
  vtkNew<vtkFloatArray> scalars;
  scalars->SetArray(grid.Values.data(), static_cast<vtkIdType>(grid.Values.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.Size.data());
  image->GetPointData()->SetScalars(scalars);
  vtkNew<vtkImageGaussianSmooth> gauss;
  gauss->SetInputData(image);
  gauss->SetRadiusFactors(3.0, 3.0, 3.0);
  gauss->SetStandardDeviations(0.5 * smoothing / grid.StepIndex[0],
                               0.5 * smoothing / grid.StepIndex[1],
                               0.5 * smoothing / grid.StepIndex[2]);
  gauss->Update();
  const float* smoothed =
      vtkFloatArray::SafeDownCast(gauss->GetOutput()->GetPointData()->GetScalars())->GetPointer(0);
  std::copy_n(smoothed, grid.Values.size(), grid.Values.begin());
}
} // namespace

FieldMethod SuitableMethod(const VoxelMask& mask)
{
  std::array<double, 3> spacing = mask.Spacing;
  std::sort(spacing.begin(), spacing.end());
  return spacing[2] >= 1.5 * spacing[1] ? FieldMethod::ShapeInterpolation : FieldMethod::Distance;
}

ScalarGrid BuildField(const VoxelMask& mask, FieldMethod method, double smoothing)
{
  if (method == FieldMethod::Plain)
  {
    return HalfLevel(mask);
  }
  ScalarGrid grid =
      method == FieldMethod::ShapeInterpolation ? InterpolateShape(mask) : DistanceInSpace(mask);
  std::array<double, 3> spacing = mask.Spacing;
  std::sort(spacing.begin(), spacing.end());
  ToOccupancy(grid, spacing[1]);
  if (smoothing > 0.0)
  {
    Smooth(grid, smoothing);
  }
  return grid;
}
} // namespace palpate
