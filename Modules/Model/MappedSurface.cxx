#include "MappedSurface.h"

#include "MeshDecimation.h"
#include "SphericalParametrisation.h"

#include <utility>

namespace palpate
{
namespace
{
// The image index of a point in mm along a mask's axes.
Vector3 IndexOf(const VoxelMask& mask, const Vector3& point)
{
  Vector3 index;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto at = static_cast<std::size_t>(axis);
    index[axis] = point[axis] / mask.Spacing[at] + mask.StartIndex[at];
  }
  return index;
}

void MoveReports(const VoxelMask& mask, const IndexToWorld& toWorld, MappedSurface& surface)
{
  const auto place = [&](const Vector3& point) { return toWorld(IndexOf(mask, point)); };
  TopologyReport& report = surface.Topology;
  for (TopologyChange* change : {&report.DroppedParts, &report.Bridges, &report.FilledCavities,
                                 &report.CutHandles, &report.FilledHandles})
  {
    change->LargestCentre = place(change->LargestCentre);
  }
  for (LostPlace& lost : surface.Lost)
  {
    lost.Farthest = place(lost.Farthest);
  }
}
} // namespace

void MoveToWorld(const IndexToWorld& toWorld, IndexedMesh& mesh)
{
  for (Vector3& point : mesh.Points)
  {
    point = toWorld(point);
  }
  if (toWorld.Axes.determinant() < 0.0)
  {
    for (std::array<int, 3>& triangle : mesh.Triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
}

void MoveToWorld(const VoxelMask& mask, const IndexToWorld& toWorld, IndexedMesh& mesh)
{
  for (Vector3& point : mesh.Points)
  {
    point = IndexOf(mask, point);
  }
  MoveToWorld(toWorld, mesh);
}

Status MakeMappedSurface(const VoxelMask& mask, const IndexToWorld& toWorld,
                         const MappedSurfaceSettings& settings, const KernelProgress& progress,
                         MappedSurface& surface)
{
  GenusZeroSurface made;
  Status status = MakeGenusZeroSurface(mask, settings.Surface, PartOf(progress, 0.0, 0.3), made);
  MappedSurface mapped;
  if (status.IsOk())
  {
    const auto outward = [&made](const Vector3& point) { return made.Field.Outward(point); };
    status = DecimateMesh(made.Mesh, {settings.Triangles}, outward, PartOf(progress, 0.3, 0.7),
                          mapped.Mesh);
  }
  if (!status.IsOk())
  {
    return status;
  }
  mapped.Topology = made.Topology;
  mapped.Lost = std::move(made.Lost);
  mapped.RestoredVolume = made.RestoredVolume;
  mapped.MaskVolume = made.MaskVolume;
  MoveToWorld(mask, toWorld, mapped.Mesh);
  MoveReports(mask, toWorld, mapped);
  SphericalParametrisation map;
  status = ParametriseOnSphere(mapped.Mesh, PartOf(progress, 0.7, 1.0), map);
  if (status.IsOk())
  {
    status = CheckSphereMap(map.Quality);
    mapped.Directions = std::move(map.Directions);
    mapped.Map = map.Quality;
  }
  surface = std::move(mapped);
  return status;
}
} // namespace palpate
