#include "ReferenceVoxels.h"

#include "LabelMask.h"
#include "MeshConversion.h"
#include "MeshVoxels.h"

#include <array>
#include <utility>

namespace palpate
{
namespace
{
constexpr double CubesOfSurface = 1.0e6;

ReferenceVoxels VoxelsOfMask(vtkImageData* image, int value)
{
  LabelMask copied = CopyLabelMask(image, value, 1);
  const IndexToWorld toWorld = IndexToWorldOf(image);
  ReferenceVoxels voxels;
  voxels.Centers.Axes = toWorld.Axes;
  const std::array<int, 3>& start = copied.Mask.StartIndex;
  voxels.Centers.Origin = toWorld(Vector3(start[0], start[1], start[2]));
  voxels.Centers.Size = copied.Mask.Size;
  voxels.Inside = std::move(copied.Mask.Inside);
  return voxels;
}
} // namespace

ReferenceVoxels ReferenceVoxelsOf(const FitResult& result)
{
  if (!result.IsOfSurface)
  {
    return VoxelsOfMask(result.Mask, result.Structure.Value);
  }
  const IndexedMesh mesh = ToIndexedMesh(result.Surface);
  ReferenceVoxels voxels;
  voxels.Centers = CubesAround(mesh, CubesOfSurface);
  if (!FindInside(mesh, voxels.Centers, false, voxels.Inside).IsOk())
  {
    // Not for a surface that was made from a file: its points are finite.
    voxels.Inside.assign(static_cast<std::size_t>(voxels.Centers.Size[0]) *
                             static_cast<std::size_t>(voxels.Centers.Size[1]) *
                             static_cast<std::size_t>(voxels.Centers.Size[2]),
                         0);
  }
  return voxels;
}
} // namespace palpate
