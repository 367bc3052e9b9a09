#include "MeasuredSurfaces.h"

#include "MeshConversion.h"

#include "vtkBoundingBox.h"

namespace palpate
{
void MeasuredSurfaces::Show(const std::map<int, vtkPolyData*>& surfaces)
{
  for (auto one = this->All.begin(); one != this->All.end();)
  {
    one = surfaces.count(one->first) == 0 ? this->All.erase(one) : std::next(one);
  }
  for (const auto& [id, surface] : surfaces)
  {
    Surface& shown = this->All[id];
    if (shown.Source != surface)
    {
      shown = {};
      shown.Source = surface;
    }
  }
}

// Null if it cannot be measured.
const SurfacePaths* MeasuredSurfaces::Prepare(Surface& surface)
{
  if (surface.Time < surface.Source->GetMTime())
  {
    surface.Time = surface.Source->GetMTime();
    std::unique_ptr<const SurfacePaths> paths;
    surface.Problem = SurfacePaths::Make(ToIndexedMesh(surface.Source), paths);
    surface.Paths = std::move(paths);
  }
  return surface.Paths.get();
}

Status MeasuredSurfaces::Prepare(int id, const SurfacePaths*& prepared)
{
  const auto found = this->All.find(id);
  if (found == this->All.end())
  {
    return Status::Failure("The structure is not displayed as a surface: make it visible, and "
                           "display it as its model or its surface.");
  }
  prepared = this->Prepare(found->second);
  return found->second.Problem;
}

std::optional<MeasuredSurfaces::Place> MeasuredSurfaces::Nearest(const Vector3& pointWorld,
                                                                 double most, int id)
{
  std::optional<Place> nearest;
  double reach = most;
  for (auto& [number, surface] : this->All)
  {
    vtkBoundingBox box(surface.Source->GetBounds());
    box.Inflate(reach);
    const bool isMeant = id == 0 || number == id;
    const SurfacePaths* prepared =
        isMeant && box.ContainsPoint(pointWorld.data()) ? this->Prepare(surface) : nullptr;
    if (prepared == nullptr)
    {
      continue;
    }
    const NearestOnMesh::Result found = prepared->Nearest().Find(pointWorld);
    if (found.Distance < reach)
    {
      reach = found.Distance;
      nearest = Place{number, found.Point};
    }
  }
  return nearest;
}

Status MeasuredSurfaces::FindPath(int id, const Vector3& from, const Vector3& to,
                                  SurfacePaths::Path& path)
{
  const SurfacePaths* prepared = nullptr;
  const Status status = this->Prepare(id, prepared);
  return status.IsOk() ? prepared->Find(from, to, path) : status;
}

Status MeasuredSurfaces::FindThickness(int id, const Vector3& pointWorld, WallThickness& wall)
{
  const SurfacePaths* prepared = nullptr;
  const Status status = this->Prepare(id, prepared);
  return status.IsOk() ? MeasureThickness(prepared->Mesh(), prepared->Nearest(), pointWorld, wall)
                       : status;
}

Status MeasuredSurfaces::FindGap(int one, int other, MeshGap& gap)
{
  for (const int id : {one, other})
  {
    const SurfacePaths* prepared = nullptr;
    Status status = this->Prepare(id, prepared);
    if (!status.IsOk())
    {
      return status;
    }
  }
  const Gap wanted{this->All[one].Paths, this->All[other].Paths, {}};
  if (this->LastGap.One != wanted.One || this->LastGap.Other != wanted.Other)
  {
    Gap found = wanted;
    const Status status = FindMeshGap(wanted.One->Mesh(), wanted.Other->Mesh(), found.Found);
    if (!status.IsOk())
    {
      return status;
    }
    this->LastGap = std::move(found);
  }
  gap = this->LastGap.Found;
  return Status::Success();
}
} // namespace palpate
