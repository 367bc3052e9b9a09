#include "ShapeField.h"

#include "AxisWeights.h"
#include "DistanceTransform.h"
#include "SliceInterpolation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double ThickSlices = 1.5;
constexpr int Rim = 2;         // empty voxels around the mask's bounds; beyond, nothing can cross
constexpr double Margin = 3.0; // nodes between the mask's bounds and the grid's border
constexpr double PartOfThickness = 1.0 / 3.0;
constexpr double MostCells = 6.0; // of the wanted ones, to resolve thin shapes
constexpr double Coarsening = 1.05;

bool IsValid(const VoxelMask& mask)
{
  double voxels = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double spacing = mask.Spacing[axis];
    if (mask.Size[axis] < 1 || !(spacing >= 1e-6 && spacing <= 1e6))
    {
      return false;
    }
    voxels *= mask.Size[axis];
  }
  return voxels == static_cast<double>(mask.Inside.size());
}

bool IsValid(const ShapeFieldSettings& settings)
{
  return settings.Spacing >= 0.0 && settings.Spacing <= 1e9 && settings.CellsOnSurface >= 10.0 &&
         settings.CellsOnSurface <= 1e8 && settings.SliceClamp > 0.0 &&
         settings.SliceClamp <= 1e3 && settings.Smoothing >= 0.0 && settings.Smoothing <= 8.0 &&
         settings.MaximumNodes >= 1e4 && settings.MaximumNodes <= 1e9;
}

// Faces across an axis between voxels inside and outside; the mask has an empty rim.
long long CountFaces(const VoxelMask& mask, std::size_t axis)
{
  const std::size_t stride = axis == 0 ? 1 : mask.Offset(0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
  long long faces = 0;
  for (std::size_t at = stride; at < mask.Inside.size(); ++at)
  {
    faces += mask.Inside[at] ^ mask.Inside[at - stride];
  }
  return faces;
}

double SurfaceArea(const VoxelMask& mask)
{
  double area = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    area += static_cast<double>(CountFaces(mask, axis)) * mask.VoxelVolume() / mask.Spacing[axis];
  }
  return area * 2.0 / 3.0;
}

double WantedSpacing(const VoxelMask& mask, const ShapeFieldSettings& settings)
{
  if (settings.Spacing > 0.0)
  {
    return settings.Spacing;
  }
  const double area = SurfaceArea(mask);
  const double volume = static_cast<double>(mask.Count()) * mask.VoxelVolume();
  const double wanted = std::sqrt(area / settings.CellsOnSurface);
  return std::clamp(PartOfThickness * 2.0 * volume / area, wanted / std::sqrt(MostCells), wanted);
}

// Voxels of the mask's bounds with a rim of empty ones around them.
VoxelMask CutOut(const VoxelMask& mask, LabelBounds& bounds)
{
  constexpr unsigned char inside = 1;
  bounds = FindLabelBounds(mask.Inside.data(), mask.Size, inside);
  if (bounds.IsEmpty())
  {
    return {};
  }
  LabelBounds box = bounds;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.First[axis] -= Rim;
    box.Last[axis] += Rim;
  }
  return CopyLabel(mask.Inside.data(), mask.Size, mask.Spacing, box, inside);
}

// The axis across thick slices, or 3 if there is none.
std::size_t SliceAxis(const std::array<double, 3>& spacing)
{
  const auto coarsest =
      static_cast<std::size_t>(std::max_element(spacing.begin(), spacing.end()) - spacing.begin());
  const double others = std::max(spacing[(coarsest + 1) % 3], spacing[(coarsest + 2) % 3]);
  return spacing[coarsest] >= ThickSlices * others ? coarsest : 3;
}

// Steps along an axis over which nodes at voxel centres repeat; 0 if they do not.
int StepsBetweenSlices(std::size_t axis, const std::array<double, 3>& voxel, double spacing)
{
  const double steps = axis == SliceAxis(voxel) ? voxel[axis] / spacing : 0.0;
  return steps < 1e6 ? static_cast<int>(std::lround(steps)) : 0;
}

// Nodes of one axis, with the grid's centre at that of the bounds. Nodes of thick slices are at
// the slices: between them, the field's kinks at the slices would be cut off, and thin parts lost.
double PlaceNodes(std::size_t axis, const LabelBounds& bounds, const std::array<double, 3>& voxel,
                  ShapeGrid& grid)
{
  const int slices = bounds.Last[axis] - bounds.First[axis];
  const double extent = slices * voxel[axis];
  double rim = (0.5 * voxel[axis]) / grid.Spacing + Margin;
  double count = std::ceil(extent / grid.Spacing + 2.0 * rim) + 1.0;
  const int steps = StepsBetweenSlices(axis, voxel, grid.Spacing);
  if (steps > 0)
  {
    rim = std::ceil(rim);
    count = static_cast<double>(slices) * steps + 2.0 * rim + 1.0;
  }
  const double centre = 0.5 * (bounds.First[axis] + bounds.Last[axis]) * voxel[axis];
  grid.Origin[static_cast<int>(axis)] = centre - 0.5 * (count - 1.0) * grid.Spacing;
  grid.Size[axis] = static_cast<int>(std::min(count, 1e9));
  return count;
}

// The spacing nearest to a wanted one of which the distance between thick slices is a multiple.
double AlignedSpacing(const std::array<double, 3>& voxel, double wanted)
{
  const std::size_t axis = SliceAxis(voxel);
  const int steps = axis < 3 ? StepsBetweenSlices(axis, voxel, wanted) : 0;
  return steps > 0 ? voxel[axis] / steps : wanted;
}

ShapeGrid GridAround(const LabelBounds& bounds, const std::array<double, 3>& voxel, double spacing,
                     double maximumNodes)
{
  ShapeGrid grid;
  while (true)
  {
    grid.Spacing = AlignedSpacing(voxel, spacing);
    double nodes = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      nodes *= PlaceNodes(axis, bounds, voxel, grid);
    }
    if (nodes <= maximumNodes)
    {
      return grid;
    }
    spacing *= Coarsening;
  }
}

// Axes along which the number of samples falls come first, for speed.
std::array<std::size_t, 3> CheapestOrder(const std::array<int, 3>& from,
                                         const std::array<int, 3>& to)
{
  std::array<std::size_t, 3> order{0, 1, 2};
  const auto growth = [&](std::size_t axis) { return static_cast<double>(to[axis]) / from[axis]; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return growth(a) < growth(b); });
  return order;
}

AxisNodes NodesAlong(std::size_t axis, const VoxelMask& mask, const ShapeGrid& grid,
                     const ShapeFieldSettings& settings)
{
  const double voxel = mask.Spacing[axis];
  return {mask.Size[axis], grid.Size[axis],
          grid.Origin[static_cast<int>(axis)] / voxel - mask.StartIndex[axis], grid.Spacing / voxel,
          settings.Smoothing};
}

std::vector<float> Resample(const VoxelMask& mask, std::vector<float> values, const ShapeGrid& grid,
                            const ShapeFieldSettings& settings)
{
  std::array<int, 3> size = mask.Size;
  for (const std::size_t axis : CheapestOrder(mask.Size, grid.Size))
  {
    values = AxisWeights(NodesAlong(axis, mask, grid, settings)).Apply(values, size, axis);
  }
  return values;
}

// Signed distances at the grid's nodes, by slice if the slices are thick.
std::vector<float> SampledDistances(const VoxelMask& mask, const ShapeGrid& grid,
                                    const ShapeFieldSettings& settings)
{
  const double halfStep = 0.5 * *std::min_element(mask.Spacing.begin(), mask.Spacing.end());
  const std::size_t across = SliceAxis(mask.Spacing);
  std::vector<float> values = SignedDistance(mask, static_cast<DistanceDomain>(across), halfStep);
  if (across == 3)
  {
    return Resample(mask, std::move(values), grid, settings);
  }
  const double bound = settings.SliceClamp * mask.Spacing[across];
  if (!settings.IsCurved)
  {
    return Resample(mask, BoundedDistances(std::move(values), bound), grid, settings);
  }
  SliceInterpolation slices(values, mask.Size, across, bound);
  for (const std::size_t axis : {(across + 1) % 3, (across + 2) % 3})
  {
    slices.Resample(AxisWeights(NodesAlong(axis, mask, grid, settings)), axis);
  }
  return slices.Between(NodesAlong(across, mask, grid, settings));
}
} // namespace

double ShapeFieldSpacing(const VoxelMask& mask, const ShapeFieldSettings& settings)
{
  LabelBounds bounds;
  const VoxelMask object = CutOut(mask, bounds);
  return bounds.IsEmpty() ? 0.0 : WantedSpacing(object, settings);
}

double ShapeField::Sample(const Vector3& point) const
{
  std::array<int, 3> base{};
  std::array<std::pair<double, std::size_t>, 3> parts{};
  const std::array<std::size_t, 3> strides{1, this->Grid.Offset(0, 1, 0),
                                           this->Grid.Offset(0, 0, 1)};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<int>(axis);
    const double last = this->Grid.Size[axis] - 1.0;
    const double at = std::clamp((point[a] - this->Grid.Origin[a]) / this->Grid.Spacing, 0.0, last);
    base[axis] = std::min(static_cast<int>(at), this->Grid.Size[axis] - 2);
    parts[axis] = {at - base[axis], strides[axis]};
  }
  // The tetrahedron's path from the lowest to the highest corner: largest part first.
  std::sort(parts.begin(), parts.end(),
            [](const auto& a, const auto& b) { return a.first > b.first; });
  std::size_t node = this->Grid.Offset(base[0], base[1], base[2]);
  double value = this->Values[node];
  for (const auto& [part, stride] : parts)
  {
    const double before = this->Values[node];
    node += stride;
    value += part * (this->Values[node] - before);
  }
  return value;
}

Vector3 ShapeField::Outward(const Vector3& point) const
{
  Vector3 normal;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3 step = 0.5 * this->Grid.Spacing * Vector3::Unit(axis);
    normal[axis] = this->Sample(point - step) - this->Sample(point + step);
  }
  return normal;
}

Status MakeShapeField(const VoxelMask& mask, const ShapeFieldSettings& settings, ShapeField& field)
{
  if (!IsValid(mask))
  {
    return Status::Failure(
        "A mask must have a positive spacing and as many voxels as its size states.");
  }
  if (!IsValid(settings))
  {
    return Status::Failure("The settings of a shape field are out of range.");
  }
  LabelBounds bounds;
  const VoxelMask object = CutOut(mask, bounds);
  if (bounds.IsEmpty())
  {
    return Status::Failure("The mask is empty.");
  }
  field.Grid =
      GridAround(bounds, mask.Spacing, WantedSpacing(object, settings), settings.MaximumNodes);
  field.Values = SampledDistances(object, field.Grid, settings);
  return Status::Success();
}
} // namespace palpate
