#include "MaskBoundary.h"

#include "MarchingTetrahedra.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// In steps of the mask's grid, with an empty layer around the mask's box.
ShapeField HalfLevels(const VoxelMask& mask)
{
  ShapeField field;
  field.Grid.Spacing = 1.0;
  field.Grid.Origin = Vector3::Constant(-1.0);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    field.Grid.Size[axis] = mask.Size[axis] + 2;
  }
  field.Values.assign(field.Grid.NodeCount(), -0.5f);
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      const unsigned char* row = mask.Inside.data() + mask.Offset(0, j, k);
      float* values = field.Values.data() + field.Grid.Offset(1, j + 1, k + 1);
      std::transform(row, row + mask.Size[0], values,
                     [](unsigned char inside) { return inside != 0 ? 0.5f : -0.5f; });
    }
  }
  return field;
}
} // namespace

Status MakeMaskBoundary(const VoxelMask& mask, const IndexToWorld& toWorld, IndexedMesh& boundary)
{
  if (mask.Count() == 0)
  {
    return Status::Failure("has no voxels");
  }
  IndexedMesh mesh;
  if (Status status = MarchTetrahedra(HalfLevels(mask), mesh); !status.IsOk())
  {
    return status;
  }
  const Vector3 start(mask.StartIndex[0], mask.StartIndex[1], mask.StartIndex[2]);
  for (Vector3& point : mesh.Points)
  {
    point = toWorld(start + point);
  }
  if (toWorld.Axes.determinant() < 0.0)
  {
    for (std::array<int, 3>& triangle : mesh.Triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  boundary = std::move(mesh);
  return Status::Success();
}
} // namespace palpate
