#include "MeasuredSurfaces.h"

#include "MeshConversion.h"
#include "OwnCopy.h"

#include "vtkBoundingBox.h"

#include <algorithm>
#include <utility>

namespace palpate
{
MeasuredSurfaces::~MeasuredSurfaces()
{
  this->Show({});
}

void MeasuredSurfaces::Show(const std::map<int, vtkPolyData*>& surfaces, const Models& models)
{
  for (auto one = this->All.begin(); one != this->All.end();)
  {
    if (surfaces.count(one->first) == 0)
    {
      this->Clear(one->second);
      one = this->All.erase(one);
    }
    else
    {
      ++one;
    }
  }
  for (const auto& [id, surface] : surfaces)
  {
    Surface& shown = this->All[id];
    if (shown.Source != surface)
    {
      this->Clear(shown);
      shown.Source = surface;
    }
    const auto model = models.find(id);
    const auto drawn = model != models.end() ? model->second : nullptr;
    if (shown.Model != drawn)
    {
      shown.Model = drawn;
      shown.OnModel.reset();
    }
  }
}

void MeasuredSurfaces::Clear(Surface& surface)
{
  if (surface.Job)
  {
    this->Jobs.Cancel(*surface.Job);
  }
  surface = {};
}

bool MeasuredSurfaces::IsPreparing() const
{
  return std::any_of(this->All.begin(), this->All.end(),
                     [](const auto& one) { return one.second.Job.has_value(); });
}

// Null if it cannot be measured, or not yet.
const SurfacePaths* MeasuredSurfaces::Prepare(int id, Surface& surface)
{
  if (surface.Time < surface.Source->GetMTime())
  {
    const vtkSmartPointer<vtkPolyData> source = surface.Source;
    const auto model = surface.Model;
    this->Clear(surface);
    surface.Source = source;
    surface.Model = model;
    surface.Time = source->GetMTime();
    if (source->GetNumberOfPolys() > MostTrianglesAtOnce)
    {
      this->StartJob(id, surface);
    }
    else
    {
      std::unique_ptr<const SurfacePaths> paths;
      surface.Problem = SurfacePaths::Make(ToIndexedMesh(source), paths);
      surface.Paths = std::move(paths);
    }
  }
  return surface.Paths.get();
}

void MeasuredSurfaces::StartJob(int id, Surface& surface)
{
  surface.Problem =
      Status::Failure("The surface is being prepared for measurements; measure again soon.");
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, id, source = OwnCopy(surface.Source.Get())](const ProgressFunction&)
  {
    std::unique_ptr<const SurfacePaths> paths;
    const Status status = SurfacePaths::Make(ToIndexedMesh(source), paths);
    return StudyJob::Delivery(
        [this, id, status, made = std::shared_ptr<const SurfacePaths>(std::move(paths))]
        {
          Surface& prepared = this->All.at(id);
          prepared.Job.reset();
          prepared.Problem = status;
          prepared.Paths = made;
        });
  };
  job.Fail = [this, id](const std::string& message)
  {
    Surface& failed = this->All.at(id);
    failed.Job.reset();
    failed.Problem = Status::Failure(message);
  };
  surface.Job = this->Jobs.Start(std::move(job));
}

Status MeasuredSurfaces::Prepare(int id, const SurfacePaths*& prepared)
{
  const auto found = this->All.find(id);
  if (found == this->All.end())
  {
    return Status::Failure("The structure is not displayed as a surface: make it visible, and "
                           "display it as its model or its surface.");
  }
  prepared = this->Prepare(id, found->second);
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
        isMeant && box.ContainsPoint(pointWorld.data()) ? this->Prepare(number, surface) : nullptr;
    if (surface.Job)
    {
      return std::nullopt;
    }
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

Status MeasuredSurfaces::FindOnModel(Surface& surface, const Vector3& from, const Vector3& to,
                                     SurfacePaths::Path& path)
{
  Status status = Status::Success();
  if (!surface.OnModel)
  {
    SurfaceGeodesics made;
    status = SurfaceGeodesics::OfModel(*surface.Model, made);
    surface.OnModel = status.IsOk() ? std::optional(made) : std::nullopt;
  }
  SurfaceGeodesics::Length found;
  status = status.IsOk() ? surface.OnModel->Find(from, to, {}, found) : status;
  path = {std::move(found.Points), found.Along};
  return status;
}

Status MeasuredSurfaces::FindPath(int id, const Vector3& from, const Vector3& to, PathOn on,
                                  SurfacePaths::Path& path)
{
  const SurfacePaths* prepared = nullptr;
  const Status status = this->Prepare(id, prepared);
  if (prepared == nullptr)
  {
    return status;
  }
  Surface& surface = this->All.at(id);
  const bool isOnModel = on == PathOn::Model && surface.Model != nullptr;
  return isOnModel ? FindOnModel(surface, from, to, path) : prepared->Find(from, to, path);
}

Status MeasuredSurfaces::FindThickness(int id, const Vector3& pointWorld, WallThickness& wall)
{
  const SurfacePaths* prepared = nullptr;
  const Status status = this->Prepare(id, prepared);
  return prepared != nullptr
             ? MeasureThickness(prepared->Mesh(), prepared->Nearest(), pointWorld, wall)
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
    Status status = FindMeshGap(wanted.One->Mesh(), wanted.Other->Mesh(), found.Found);
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
