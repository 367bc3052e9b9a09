#include "ComparedBody.h"

#include "MaskBoundary.h"
#include "MeshDistances.h"
#include "MeshMending.h"
#include "MeshRefinement.h"
#include "MeshVoxels.h"
#include "SignedMeshDistances.h"
#include "StarShape.h"
#include "SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace palpate
{
namespace
{
// Of a mesh after its long edges were split.
constexpr double WantedTriangles = 40000.0;
constexpr int MostSplitTriangles = 400000;

Vector3 SurfaceCentroid(const IndexedMesh& mesh, const std::vector<double>& parts)
{
  Vector3 centroid = Vector3::Zero();
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    centroid += parts[i] * mesh.Points[i];
  }
  return centroid;
}

// About a point, so that it encloses a volume.
std::shared_ptr<const IndexedMesh> ScaledTo(const IndexedMesh& mesh, const Vector3& center,
                                            double volume)
{
  const double drawn = DescribeTopology(mesh).Volume;
  const double scale = drawn > 0.0 ? std::cbrt(volume / drawn) : 1.0;
  IndexedMesh scaled = mesh;
  for (Vector3& point : scaled.Points)
  {
    point = center + scale * (point - center);
  }
  return std::make_shared<const IndexedMesh>(std::move(scaled));
}

double VoxelVolumeOf(const IndexToWorld& toWorld)
{
  return std::abs(toWorld.Axes.determinant());
}
} // namespace

Status ComparedBody::OfMask(VoxelMask mask, const IndexToWorld& toWorld, ComparedBody& made)
{
  ComparedBody body;
  if (Status status = MakeMaskBoundary(mask, toWorld, body.Mesh); !status.IsOk())
  {
    return status;
  }
  body.EnclosedVolume = static_cast<double>(mask.Count()) * VoxelVolumeOf(toWorld);
  body.Voxels = std::make_shared<const PlacedMask>(PlacedMask{std::move(mask), toWorld});
  Status status = body.Finish();
  made = std::move(body);
  return status;
}

Status ComparedBody::OfMesh(IndexedMesh mesh, ComparedBody& made)
{
  ComparedBody body;
  MeshMends mends;
  if (Status status = MendMesh(mesh, false, mends); !status.IsOk())
  {
    return status;
  }
  const SurfaceTopology topology = DescribeTopology(mesh);
  if (!(topology.Area > 0.0))
  {
    return Status::Failure("has no triangles with an area");
  }
  // Of an equilateral triangle with a part of the area; long ones are split to sides below twice
  // that.
  const double side = std::sqrt(4.0 / std::sqrt(3.0) * topology.Area / WantedTriangles);
  if (mesh.Triangles.size() < static_cast<std::size_t>(MostSplitTriangles))
  {
    SplitLongEdges(mesh, 2.0 * side, MostSplitTriangles);
  }
  body.Mesh = std::move(mesh);
  body.Holes = std::max(topology.Holes, topology.BoundaryEdges > 0 ? 1 : 0);
  body.EnclosedVolume =
      body.IsClosed() ? std::abs(topology.Volume) : std::numeric_limits<double>::quiet_NaN();
  body.HasPairsOnly = topology.IsConsistent();
  Status status = body.Finish();
  body.IrregularPart = status.IsOk() && body.IsClosed() ? IrregularShare(body.Mesh) : 0.0;
  made = std::move(body);
  return status;
}

Status ComparedBody::OfModel(const SurfaceModel& model, ComparedBody& made)
{
  ComparedBody body;
  const auto foot = std::make_shared<const ModelFoot>(model);
  if (!(foot->Volume() > 0.0) || !std::isfinite(foot->Volume()))
  {
    return Status::Failure("encloses no volume");
  }
  body.Foot = foot;
  body.Mesh = foot->Mesh();
  body.EnclosedVolume = foot->Volume();
  body.SurfaceArea = foot->Area();
  Status status = body.Finish();
  if (status.IsOk())
  {
    body.Scaled = ScaledTo(body.Mesh, body.Middle, body.EnclosedVolume);
  }
  made = std::move(body);
  return status;
}

Status ComparedBody::Finish()
{
  const auto isNear = [](const Vector3& point)
  { return point.cwiseAbs().maxCoeff() <= FarthestCompared; };
  if (!std::all_of(this->Mesh.Points.begin(), this->Mesh.Points.end(), isNear))
  {
    return Status::Failure("has points that are farther than 10 km from the origin");
  }
  if (Status status = NearestOnMesh::Make(this->Mesh, this->Nearest); !status.IsOk())
  {
    return status;
  }
  this->Parts = PointAreas(this->Mesh);
  const double area = // of the triangles
      std::accumulate(this->Parts.begin(), this->Parts.end(), 0.0);
  if (!(area > 0.0) || !std::isfinite(area))
  {
    return Status::Failure("has no area");
  }
  this->SurfaceArea = this->Foot != nullptr ? this->SurfaceArea : area;
  std::for_each(this->Parts.begin(), this->Parts.end(), [area](double& part) { part /= area; });
  const bool hasInside = this->IsClosed() && this->EnclosedVolume > 0.0;
  this->Middle = hasInside ? VolumeCentroid(this->Mesh) : SurfaceCentroid(this->Mesh, this->Parts);
  return Status::Success();
}

Status ComparedBody::DistancesOf(const std::vector<Vector3>& points, const KernelProgress& progress,
                                 std::vector<double>& distances) const
{
  constexpr std::size_t Block = 4096;
  const bool needsSides = this->IsClosed() && this->Foot == nullptr;
  const std::vector<std::uint8_t> inside =
      needsSides ? InsideOf(points, this->Mesh) : std::vector<std::uint8_t>();
  std::vector<double> found;
  found.reserve(points.size());
  NearestOnMesh::Result near;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (i % Block == 0 && progress &&
        !progress(static_cast<double>(i) / static_cast<double>(points.size())))
    {
      return Status::Failure("cancelled");
    }
    near = this->Nearest.FindFrom(points[i], near.Triangle); // neighbours often follow each other
    const double distance =
        this->Foot != nullptr ? this->Foot->SignedDistance(points[i], near) : near.Distance;
    found.push_back(needsSides && inside[i] != 0 ? -distance : distance);
  }
  distances = std::move(found);
  return Status::Success();
}
} // namespace palpate
