#include "MirroredBody.h"

#include "BodyMotion.h"

#include <utility>

namespace palpate
{
namespace
{
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
} // namespace

Status MirrorOnto(const ComparedBody& fixed, const KernelProgress& progress, ComparedBody& body,
                  MirrorMatch& match)
{
  IndexedMesh mesh = MirroredMesh(body.Surface());
  const Vector3 middle = MirroredPoint(body.Centroid());
  SurfaceRegistration found;
  if (Status status = RegisterToBody(mesh, middle, fixed, progress, found); !status.IsOk())
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
