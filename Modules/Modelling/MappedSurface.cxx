#include "MappedSurface.h"

#include "MeshDecimation.h"
#include "SphericalParametrisation.h"

#include <utility>

namespace palpate
{
namespace
{
// From mm along a mask's axes to the world.
struct MaskToWorld
{
  const VoxelMask& Mask;
  const IndexToWorld& ToWorld;

  Vector3 operator()(const Vector3& point) const
  {
    Vector3 index;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto at = static_cast<std::size_t>(axis);
      index[axis] = point[axis] / this->Mask.Spacing[at] + this->Mask.StartIndex[at];
    }
    return this->ToWorld(index);
  }
};

void MoveReports(const MaskToWorld& toWorld, MappedSurface& surface)
{
  TopologyReport& report = surface.Topology;
  for (TopologyChange* change : {&report.DroppedParts, &report.Bridges, &report.FilledCavities,
                                 &report.CutHandles, &report.FilledHandles})
  {
    change->LargestCentre = toWorld(change->LargestCentre);
  }
  for (LostPlace& place : surface.Lost)
  {
    place.Farthest = toWorld(place.Farthest);
  }
}
} // namespace

void MoveToWorld(const VoxelMask& mask, const IndexToWorld& toWorld, IndexedMesh& mesh)
{
  const MaskToWorld place{mask, toWorld};
  for (Vector3& point : mesh.Points)
  {
    point = place(point);
  }
  if (toWorld.Axes.determinant() < 0.0)
  {
    for (std::array<int, 3>& triangle : mesh.Triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
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
  MoveReports({mask, toWorld}, mapped);
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
