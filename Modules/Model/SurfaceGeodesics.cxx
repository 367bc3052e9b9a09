#include "SurfaceGeodesics.h"

#include "GeodesicDistances.h"

#include <utility>

namespace palpate
{
Status SurfaceGeodesics::OfModel(const OrganModel& model, SurfaceGeodesics& made)
{
  std::unique_ptr<const ModelPaths> paths;
  Status status = ModelPaths::Make(model, paths);
  if (status.IsOk())
  {
    made = {};
    made.OnModel = std::move(paths);
  }
  return status;
}

Status SurfaceGeodesics::OfMesh(IndexedMesh mesh, SurfaceGeodesics& made)
{
  std::unique_ptr<const SurfacePaths> paths;
  Status status = SurfacePaths::Make(std::move(mesh), paths);
  if (status.IsOk())
  {
    made = {};
    made.OnTriangles = std::move(paths);
  }
  return status;
}

const IndexedMesh& SurfaceGeodesics::Mesh() const noexcept
{
  return this->IsOnModel() ? this->OnModel->Drawing() : this->OnTriangles->Mesh();
}

Status SurfaceGeodesics::Find(const Vector3& from, const Vector3& to,
                              const KernelProgress& progress, Length& found) const
{
  Status status = Status::Success();
  if (this->IsOnModel())
  {
    GeodesicCurve curve;
    status = this->OnModel->Find(from, to, progress, curve);
    found.Along = curve.Length;
    found.Uncertainty = curve.Uncertainty;
    found.Points = std::move(curve.Points);
  }
  else
  {
    SurfacePaths::Path path;
    status = this->OnTriangles->Find(from, to, path);
    SurfacePaths::Path other = path;
    if (status.IsOk() && this->Mesh().Triangles.size() <= MostForShortest)
    {
      status = this->OnTriangles->FindShortest(from, to, progress, other);
    }
    SurfacePaths::Path& shorter = other.Length < path.Length ? other : path;
    found.Along = shorter.Length;
    found.Uncertainty.reset();
    found.Points = std::move(shorter.Points);
  }
  if (status.IsOk())
  {
    found.From = found.Points.front();
    found.To = found.Points.back();
    found.Direct = (found.To - found.From).norm();
  }
  return status;
}

Status SurfaceGeodesics::Distances(const Vector3& from, const KernelProgress& progress,
                                   std::vector<double>& distances) const
{
  return this->IsOnModel()
             ? this->OnModel->Distances(from, progress, distances)
             : FindGeodesicDistances(this->Mesh(), this->OnTriangles->Nearest().Find(from),
                                     progress, distances);
}
} // namespace palpate
