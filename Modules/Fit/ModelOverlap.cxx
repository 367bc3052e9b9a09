#include "ModelOverlap.h"

#include "MaskOverlap.h"
#include "MeshConversion.h"
#include "MeshVoxels.h"
#include "Units.h"

#include "vtkBoundingBox.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace palpate
{
namespace
{
constexpr double CubesOfSurface = 1.0e6;

bool IsWithin(const double* bounds, const VoxelCenters& grid)
{
  const Vector3 last(grid.Size[0] - 1, grid.Size[1] - 1, grid.Size[2] - 1);
  const Vector3 end = grid.Origin + grid.Axes * last;
  const vtkBoundingBox box(grid.Origin.x(), end.x(), grid.Origin.y(), end.y(), grid.Origin.z(),
                           end.z());
  return box.Contains(vtkBoundingBox(bounds)) != 0;
}

WindingOverlap OverlapOfSurfaces(const FitResult& result, const VoxelCenters& grid)
{
  std::vector<std::uint8_t> inside;
  std::vector<std::int16_t> numbers;
  if (!FindInside(ToIndexedMesh(result.Surface), grid, true, inside).IsOk() ||
      !FindWindingNumbers(ToIndexedMesh(result.ModelSurface), grid, numbers).IsOk())
  {
    return {0, 1}; // a model without finite points overlaps nothing
  }
  WindingOverlap overlap = CompareWithMask(numbers, inside.data());
  if (!IsWithin(result.ModelSurface->GetBounds(), grid))
  {
    const double volume = CubicMillimetersPerMilliliter * std::abs(result.ModelMilliliters);
    const double cubes = volume / std::abs(grid.Axes.determinant());
    overlap.Inside = std::max<std::int64_t>(overlap.Inside, std::llround(std::min(cubes, 1e18)));
  }
  return overlap;
}
} // namespace

WindingOverlap MeasureOverlap(FitResult& result)
{
  WindingOverlap overlap;
  if (result.IsOfSurface)
  {
    const VoxelCenters grid = CubesAround(ToIndexedMesh(result.Surface), CubesOfSurface);
    result.DiceSpacing = grid.Axes(0, 0);
    overlap = OverlapOfSurfaces(result, grid);
  }
  else
  {
    const FitSettings& settings = result.Settings;
    overlap = OverlapOfSurfaceAndMask(ToIndexedMesh(result.ModelSurface), result.Mask,
                                      result.Structure.Value,
                                      settings.WantsOneComponent() ? settings.Component : 0);
  }
  result.Dice = overlap.Dice();
  return overlap;
}
} // namespace palpate
