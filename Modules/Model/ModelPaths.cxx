#include "ModelPaths.h"

#include "GeodesicDistances.h"

#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
SurfaceModel AsSurface(const OrganModel& model)
{
  const auto* star = std::get_if<RadialModel>(&model);
  return star != nullptr ? SurfaceModel::FromModel(*star) : std::get<SurfaceModel>(model);
}
} // namespace

ModelPaths::ModelPaths(const OrganModel& model) : Surface(AsSurface(model)), Foot(model) {}

Status ModelPaths::Make(const OrganModel& model, std::unique_ptr<const ModelPaths>& made)
{
  std::unique_ptr<ModelPaths> paths(new ModelPaths(model));
  if (!(paths->Foot.Volume() > 0.0) || !std::isfinite(paths->Foot.Volume()))
  {
    return Status::Failure("encloses no volume");
  }
  Status status = NearestOnMesh::Make(paths->Drawing(), paths->Nearest);
  if (status.IsOk())
  {
    status = SurfacePaths::Make(paths->Foot.CoarseMesh(), paths->CoarsePaths);
  }
  if (status.IsOk())
  {
    made = std::move(paths);
  }
  return status;
}

GeodesicCurve ModelPaths::CurveFrom(const Vector3& start, const SurfacePaths::Path& path,
                                    const Vector3& end) const
{
  std::vector<Vector3> parameters{start};
  for (const Vector3& point : path.Points)
  {
    parameters.push_back(this->Foot.ParameterAt(this->Nearest.Find(point)));
  }
  parameters.push_back(end);
  return Straightened(this->Surface, parameters);
}

Status ModelPaths::Find(const Vector3& from, const Vector3& to, const KernelProgress& progress,
                        GeodesicCurve& found) const
{
  const Vector3 start = this->Foot.FootOf(from, this->Nearest.Find(from));
  const Vector3 end = this->Foot.FootOf(to, this->Nearest.Find(to));
  const Vector3 startWorld = this->Surface.Point(start);
  const Vector3 endWorld = this->Surface.Point(end);
  SurfacePaths::Path path;
  Status status = this->CoarsePaths->FindShortest(startWorld, endWorld, progress, path);
  if (status.IsOk())
  {
    found = this->CurveFrom(start, path, end);
    status = this->CoarsePaths->Find(startWorld, endWorld, path);
  }
  if (status.IsOk())
  {
    GeodesicCurve other = this->CurveFrom(start, path, end);
    if (other.Length < found.Length)
    {
      found = std::move(other);
    }
  }
  return status;
}

Status ModelPaths::Distances(const Vector3& from, const KernelProgress& progress,
                             std::vector<double>& distances) const
{
  return FindGeodesicDistances(this->Drawing(), this->Nearest.Find(from), progress, distances);
}
} // namespace palpate
