#include "MirroredBody.h"

#include "SurfaceRegistration.h"

#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t MostPoints = 5000; // of a registration

Vector3 MirroredPoint(const Vector3& point)
{
  return {-point.x(), point.y(), point.z()};
}

IndexedMesh MirroredMesh(IndexedMesh mesh)
{
  for (Vector3& point : mesh.Points)
  {
    point = MirroredPoint(point);
  }
  for (auto& [a, b, c] : mesh.Triangles)
  {
    std::swap(b, c); // faces outwards again
  }
  return mesh;
}

// Every n-th point.
std::vector<Vector3> SomePoints(const std::vector<Vector3>& points)
{
  const std::size_t step = points.size() / MostPoints + 1;
  std::vector<Vector3> some;
  for (std::size_t i = 0; i < points.size(); i += step)
  {
    some.push_back(points[i]);
  }
  return some;
}
} // namespace

Status MirrorOnto(const ComparedBody& fixed, const KernelProgress& progress, ComparedBody& body,
                  MirrorMatch& match)
{
  IndexedMesh mesh = MirroredMesh(body.Surface());
  const Vector3 middle = MirroredPoint(body.Centroid());
  Eigen::Affine3d start = Eigen::Affine3d::Identity();
  start.translation() = fixed.Centroid() - middle;
  SurfaceRegistration found;
  if (Status status =
          RegisterToSurface(SomePoints(mesh.Points), fixed.Surface(), start, {}, progress, found);
      !status.IsOk())
  {
    return status;
  }
  for (Vector3& point : mesh.Points)
  {
    point = found.Map * point;
  }
  match.Turn = Eigen::AngleAxisd(found.Map.linear()).angle();
  match.Shift = found.Map * middle - middle;
  return ComparedBody::OfMesh(std::move(mesh), body);
}
} // namespace palpate
