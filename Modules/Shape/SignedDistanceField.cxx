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

// Steps between the mask's slices that make samples about as dense as in the slices.
int RefinementAlong(std::size_t axis, const VoxelMask& mask)
{
  const double inPlane = std::sqrt(mask.Spacing[(axis + 1) % 3] * mask.Spacing[(axis + 2) % 3]);
  const double wanted = std::round(mask.Spacing[axis] / inPlane);
  const double affordable = MaximumSamples / static_cast<double>(mask.Inside.size());
  return static_cast<int>(
      std::clamp(std::min(wanted, affordable), 1.0, static_cast<double>(MaximumRefinement)));
}

// The signed in-plane distance of slices across an axis, clamped to one slice step.
std::vector<float> SliceDistances(std::size_t axis, const VoxelMask& mask)
{
  const double halfStep = 0.25 * (mask.Spacing[(axis + 1) % 3] + mask.Spacing[(axis + 2) % 3]);
  std::vector<float> field = SignedDistance(mask, static_cast<DistanceDomain>(axis), halfStep);
  const auto bound = static_cast<float>(mask.Spacing[axis]);
  for (float& value : field)
  {
    value = std::clamp(value, -bound, bound);
  }
  return field;
}

// Interpolates the slices of a signed in-plane distance along the coarsest axis. As the distance is
// clamped to one slice step, outlines that lie closer than that from slice to slice are joined by
// an oblique wall; where they lie further apart, or a slice is empty, the shape ends half way
// between the slices with a rounded edge, as in the mask itself. So the surface never crosses a
// line between voxel centres of one kind, and stays within half a step of the mask's own half
// level.
ScalarGrid InterpolateShape(const VoxelMask& mask)
{
  const auto axis = static_cast<std::size_t>(
      std::max_element(mask.Spacing.begin(), mask.Spacing.end()) - mask.Spacing.begin());
  const int refinement = RefinementAlong(axis, mask);
  const std::vector<float> field = SliceDistances(axis, mask);
  const std::array<std::size_t, 3> strides{1, mask.Offset(0, 1, 0), mask.Offset(0, 0, 1)};
  ScalarGrid grid = GridOf(mask);
  grid.Size[axis] = (mask.Size[axis] - 1) * refinement + 1;
  grid.StepIndex[axis] = 1.0 / refinement;
  grid.Spacing[axis] /= refinement;
  grid.Values.reserve(grid.SliceStride(3));
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    for (int j = 0; j < grid.Size[1]; ++j)
    {
      for (int i = 0; i < grid.Size[0]; ++i)
      {
        std::array<int, 3> at{i, j, k};
        const int slice = std::min(at[axis] / refinement, mask.Size[axis] - 2);
        const double part = static_cast<double>(at[axis] - slice * refinement) / refinement;
        at[axis] = slice;
        const float* low = &field[mask.Offset(at[0], at[1], at[2])];
        grid.Values.push_back(*low + static_cast<float>(part) * (low[strides[axis]] - *low));
      }
    }
  }
  return grid;
}

ScalarGrid DistanceInSpace(const VoxelMask& mask)
{
  ScalarGrid grid = GridOf(mask);
  const double meanSpacing = std::cbrt(mask.VoxelVolume());
  grid.Values = SignedDistance(mask, DistanceDomain::Space, 0.5 * meanSpacing);
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
