#include "BodyMotion.h"

#include "NearestOnMesh.h"

#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t MostPoints = 5000; // of a registration

// Carried by the rigid map, then by the nearest point of the surface.
Status MoveLandmarks(const IndexedMesh& from, const IndexedMesh& to, const Eigen::Affine3d& map,
                     const std::vector<Vector3>& landmarks, std::vector<Vector3>& moved)
{
  NearestOnMesh before;
  NearestOnMesh after;
  Status status = NearestOnMesh::Make(from, before);
  status = status.IsOk() ? NearestOnMesh::Make(to, after) : status;
  if (!status.IsOk())
  {
    return status;
  }
  for (const Vector3& landmark : landmarks)
  {
    const Vector3 carried = map * before.Find(landmark).Point;
    moved.emplace_back(map * landmark + after.Find(carried).Point - carried);
  }
  return status;
}
} // namespace

std::vector<Vector3> SomePoints(const IndexedMesh& mesh)
{
  const std::size_t step = mesh.Points.size() / MostPoints + 1;
  std::vector<Vector3> some;
  for (std::size_t i = 0; i < mesh.Points.size(); i += step)
  {
    some.push_back(mesh.Points[i]);
  }
  return some;
}

Status RegisterToBody(const IndexedMesh& moving, const Vector3& middle, const ComparedBody& fixed,
                      const KernelProgress& progress, SurfaceRegistration& made)
{
  Eigen::Affine3d start = Eigen::Affine3d::Identity();
  start.translation() = fixed.Centroid() - middle;
  return RegisterToSurface(SomePoints(moving), fixed.Surface(), start, {}, progress, made);
}

Status FindBodyMotion(const ComparedBody& from, const ComparedBody& to,
                      const std::vector<Vector3>& landmarks, const KernelProgress& progress,
                      BodyMotion& motion)
{
  SurfaceRegistration found;
  if (Status status = RegisterToBody(from.Surface(), from.Centroid(), to, progress, found);
      !status.IsOk())
  {
    return status;
  }
  BodyMotion made;
  made.Turn = Eigen::AngleAxisd(found.Map.linear()).angle();
  made.Shift = found.Map * from.Centroid() - from.Centroid();
  made.Rest = found.Rms;
  const Status status = landmarks.empty() ? Status::Success()
                                          : MoveLandmarks(from.Surface(), to.Surface(), found.Map,
                                                          landmarks, made.Landmarks);
  if (status.IsOk())
  {
    motion = std::move(made);
  }
  return status;
}
} // namespace palpate
