#include "ComparedBody.h"

#include "DistanceSampler.h"
#include "MaskSurface.h"
#include "MeshDistances.h"
#include "MeshMending.h"
#include "MeshRefinement.h"
#include "MeshVoxels.h"
#include "ModelFoot.h"
#include "SignedMeshDistances.h"
#include "SpatialOrder.h"
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

Vector3 SurfaceCentroid(const IndexedMesh& mesh, const std::vector<double>& areas, double area)
{
  Vector3 centroid = Vector3::Zero();
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    centroid += areas[i] / area * mesh.Points[i];
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
  body.TakeMask(std::move(mask), toWorld);
  Status status = body.Finish();
  made = std::move(body);
  return status;
}

Status ComparedBody::OfMaskShape(VoxelMask mask, const IndexToWorld& toWorld, ComparedBody& made)
{
  MaskSurfaceSettings settings;
  settings.Component = 0;
  settings.Shape.CellsOnSurface = MaskSurfaceSettings::CellsOfModel;
  MaskSurface surface;
  ComparedBody body;
  if (Status status = MakeMaskSurface(mask, toWorld, settings, {}, surface); !status.IsOk())
  {
    return status;
  }
  body.Mesh = std::move(surface.Mesh);
  body.TakeMask(std::move(mask), toWorld);
  Status status = body.Finish();
  made = std::move(body);
  return status;
}

void ComparedBody::TakeMask(VoxelMask mask, const IndexToWorld& toWorld)
{
  this->EnclosedVolume = static_cast<double>(mask.Count()) * VoxelVolumeOf(toWorld);
  this->Voxels = std::make_shared<const PlacedMask>(PlacedMask{std::move(mask), toWorld});
}

Status ComparedBody::OfMesh(IndexedMesh mesh, ComparedBody& made)
{
  ComparedBody body;
  MeshMends mends;
  if (Status status = MendMesh(mesh, 0, mends); !status.IsOk())
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

Status ComparedBody::OfModel(const OrganModel& model, ComparedBody& made)
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
  const std::vector<double> areas = PointAreas(this->Mesh);
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0); // of the triangles
  if (!(area > 0.0) || !std::isfinite(area))
  {
    return Status::Failure("has no area");
  }
  this->SurfaceArea = this->Foot != nullptr ? this->SurfaceArea : area;
  const bool hasInside = this->IsClosed() && this->EnclosedVolume > 0.0;
  this->Middle = hasInside ? VolumeCentroid(this->Mesh) : SurfaceCentroid(this->Mesh, areas, area);
  return Status::Success();
}

// The ball around a point up to the surface lies on one side of it: a point in that of the one
// before, or around which it is, is on the same side and needs no test of its own.
void ComparedBody::GiveSigns(const std::vector<Vector3>& points,
                             std::vector<double>& distances) const
{
  if (!this->IsClosed() || this->Foot != nullptr)
  {
    return;
  }
  const std::vector<int> order = SpatialOrder(points);
  std::vector<Vector3> tested;
  std::vector<std::size_t> tests;
  tests.reserve(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const int point = order[i];
    const int before = order[i == 0 ? 0 : i - 1];
    if (i == 0 ||
        !((points[point] - points[before]).norm() < std::max(distances[point], distances[before])))
    {
      tested.push_back(points[point]);
    }
    tests.push_back(tested.size() - 1);
  }
  const std::vector<std::uint8_t> inside = InsideOf(tested, this->Mesh);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    double& distance = distances[order[i]];
    distance = inside[tests[i]] != 0 ? -distance : distance;
  }
}

IndexedMesh ComparedBody::CoarseSurface() const
{
  return this->Foot->CoarseMesh();
}

Status ComparedBody::DistancesOf(const std::vector<Vector3>& points, const KernelProgress& progress,
                                 std::vector<double>& distances) const
{
  Status status = this->Measure(points, progress, distances);
  if (status.IsOk())
  {
    this->GiveSigns(points, distances);
  }
  return status;
}

// Signed from a model only.
Status ComparedBody::Measure(const std::vector<Vector3>& points, const KernelProgress& progress,
                             std::vector<double>& distances) const
{
  constexpr std::size_t Block = 16384;
  std::vector<double> found;
  found.reserve(points.size());
  for (std::size_t begin = 0; begin < points.size(); begin += Block)
  {
    if (progress && !progress(static_cast<double>(begin) / static_cast<double>(points.size())))
    {
      return Status::Failure("cancelled");
    }
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto count = static_cast<std::ptrdiff_t>(std::min(Block, points.size() - begin));
    const std::vector<Vector3> block(first, first + count);
    if (this->Foot == nullptr)
    {
      const std::vector<double> lengths = this->Nearest.DistancesOf(block);
      found.insert(found.end(), lengths.begin(), lengths.end());
      continue;
    }
    const std::vector<NearestOnMesh::Result> near = this->Nearest.FindAll(block);
    for (std::size_t i = 0; i < block.size(); ++i)
    {
      found.push_back(this->Foot->SignedDistance(block[i], near[i]));
    }
  }
  distances = std::move(found);
  return Status::Success();
}

Status ComparedBody::SampleDistancesFrom(const ComparedBody& other, const KernelProgress& progress,
                                         DistanceSamples& samples) const
{
  SampledSurface surface{this->Mesh, {}};
  if (this->Foot != nullptr)
  {
    surface.Places.Points = this->Foot->MeshParameters();
    surface.PointAt = [this](const Vector3& direction) { return this->Foot->PointAt(direction); };
  }
  double done = 0.0; // the number of steps is not known
  Status status = SampleDistances(
      surface,
      [&](const std::vector<Vector3>& points, std::vector<double>& distances)
      {
        const double begin = std::exchange(done, 0.5 * (1.0 + done));
        return other.Measure(points, PartOf(progress, begin, done), distances);
      },
      samples);
  if (status.IsOk())
  {
    other.GiveSigns(samples.Points, samples.Values);
  }
  return status;
}
} // namespace palpate
