#include "SphericalParametrisation.h"

#include "MapRefinement.h"
#include "MeshSimplification.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
// Sweeps run whenever the number of vertices has grown by this factor, and at the end, at most:
constexpr double LevelGrowth = 1.5;
constexpr int LastSweeps = 30;
// A triangle's height has to exceed this share of the surface's extent: rounding of coordinates.
constexpr double LeastHeight = 1e-12;
// Of the progress: simplification, refinement, last sweeps.
constexpr double SimplificationShare = 0.3;
constexpr double RefinementShare = 0.4;
constexpr std::size_t VerticesPerReport = 1024; // vertices

const char* const Cancelled = "The parametrisation was cancelled.";
const char* const Degenerate =
    "The surface is too thin or too long for a map to the sphere; smooth or split it.";

// Centred, with a surface area of 4 pi.
Status ScalePoints(const IndexedMesh& surface, std::vector<MappedVertex>& vertices)
{
  Eigen::AlignedBox3d box;
  for (const Vector3& point : surface.Points)
  {
    if (!point.allFinite())
    {
      return Status::Failure("A point of the surface is not finite.");
    }
    box.extend(point);
  }
  const double extent = box.sizes().maxCoeff();
  if (!std::isnormal(extent))
  {
    return Status::Failure("The surface has no extent, or one beyond double precision.");
  }
  vertices.reserve(surface.Points.size());
  for (const Vector3& point : surface.Points)
  {
    vertices.push_back({(point - box.center()) / extent, Vector3::Zero()});
  }
  double area = 0.0;
  for (const std::array<int, 3>& t : surface.Triangles)
  {
    const Vector3& a = vertices[static_cast<std::size_t>(t[0])].Point;
    const Vector3 ab = vertices[static_cast<std::size_t>(t[1])].Point - a;
    const Vector3 ac = vertices[static_cast<std::size_t>(t[2])].Point - a;
    const double twice = ab.cross(ac).norm();
    const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
    if (!(twice > LeastHeight * longest))
    {
      return Status::Failure("A triangle of the surface has no area.");
    }
    area += 0.5 * twice;
  }
  const double scale = std::sqrt(4.0 * M_PI / area);
  for (MappedVertex& vertex : vertices)
  {
    vertex.Point *= scale;
  }
  return Status::Success();
}

bool Report(const KernelProgress& progress, double fraction)
{
  return !progress || progress(fraction);
}

Status ReturnAll(const MeshSimplification& simplification, const KernelProgress& progress,
                 MapRefinement& refinement)
{
  const std::size_t count = simplification.Removals.size();
  double nextLevel = LevelGrowth * 4.0;
  for (std::size_t i = count; i > 0; --i)
  {
    if (!refinement.Return(simplification, simplification.Removals[i - 1]))
    {
      return Status::Failure(Degenerate);
    }
    if (static_cast<double>(refinement.Size()) >= nextLevel)
    {
      nextLevel *= LevelGrowth;
      refinement.SweepLevel();
    }
    const double done = static_cast<double>(count - i) / static_cast<double>(count);
    if (i % VerticesPerReport == 0 &&
        !Report(progress, SimplificationShare + RefinementShare * done))
    {
      return Status::Failure(Cancelled);
    }
  }
  return Status::Success();
}

Status SweepLast(const KernelProgress& progress, MapRefinement& refinement)
{
  constexpr double Before = SimplificationShare + RefinementShare;
  refinement.WakeAll();
  bool any = true;
  for (int i = 0; i < LastSweeps && any; ++i)
  {
    if (!Report(progress, Before + (1.0 - Before) * i / LastSweeps))
    {
      return Status::Failure(Cancelled);
    }
    any = refinement.Sweep();
  }
  return Status::Success();
}

Status MapVertices(VertexRings& rings, const KernelProgress& progress,
                   std::vector<MappedVertex>& vertices)
{
  MeshSimplification simplification;
  const auto share = [&](double fraction)
  { return Report(progress, SimplificationShare * fraction); };
  if (!Simplify(vertices, share, rings, simplification))
  {
    return Status::Failure(Cancelled);
  }
  MapRefinement refinement(rings, vertices);
  Status status = ReturnAll(simplification, progress, refinement);
  return status.IsOk() ? SweepLast(progress, refinement) : status;
}
} // namespace

Status ParametriseOnSphere(const IndexedMesh& surface, const KernelProgress& progress,
                           SphericalParametrisation& result)
{
  VertexRings rings;
  std::vector<MappedVertex> vertices;
  Status status = VertexRings::From(surface, rings);
  status = status.IsOk() ? ScalePoints(surface, vertices) : status;
  status = status.IsOk() ? MapVertices(rings, progress, vertices) : status;
  if (!status.IsOk())
  {
    return status;
  }
  std::vector<Vector3> directions;
  directions.reserve(vertices.size());
  for (const MappedVertex& vertex : vertices)
  {
    directions.push_back(vertex.Direction);
  }
  if (!IsBijective(surface.Triangles, directions))
  {
    return Status::Failure(Degenerate);
  }
  if (!Report(progress, 1.0))
  {
    return Status::Failure(Cancelled);
  }
  result.Quality = MeasureSphereMap(surface, directions);
  result.Directions = std::move(directions);
  return Status::Success();
}
} // namespace palpate
