#include "SphericalParametrisation.h"

#include "CoarseMap.h"
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
// Of the surface whose map is searched for; finer levels only sweep, since maps of less energy do
// not fit better and cross themselves a little more.
constexpr int CoarseVertices = 500;
// At the end, at most.
constexpr int LastSweeps = 30;
// A triangle's height has to exceed this share of the surface's extent: rounding of coordinates.
constexpr double LeastHeight = 1e-12;
// Of the progress: simplification, coarse map, refinement, last sweeps.
constexpr double SimplificationShare = 0.15;
constexpr double CoarseShare = 0.35;
constexpr double RefinementShare = 0.35;

const char* const Cancelled = "The parametrisation was cancelled.";
// As a predicate of the structure.
const char* const Degenerate = "is too thin or too long for a map to the sphere";

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

void SweepLast(const KernelProgress& report, MapRefinement& refinement)
{
  constexpr double Before = SimplificationShare + CoarseShare + RefinementShare;
  refinement.WakeAll();
  bool any = true;
  for (int i = 0; i < LastSweeps && any; ++i)
  {
    any = report(Before + (1.0 - Before) * i / LastSweeps) && refinement.Sweep();
  }
}

Status MapVertices(VertexRings& rings, const KernelProgress& progress,
                   std::vector<MappedVertex>& vertices)
{
  bool isCancelled = false;
  const auto report = [&](double fraction)
  {
    isCancelled = isCancelled || !Report(progress, fraction);
    return !isCancelled;
  };
  const auto simplified = [&](double part) { return report(SimplificationShare * part); };
  const auto coarse = [&](double part) { return report(SimplificationShare + CoarseShare * part); };
  const auto returned = [&](double part)
  { return report(SimplificationShare + CoarseShare + RefinementShare * part); };
  MeshSimplification simplification;
  SimplificationSettings settings;
  settings.Vertices = CoarseVertices;
  bool isMapped = Simplify(vertices, settings, simplified, rings, simplification) &&
                  MapCoarseSurface(rings, coarse, vertices);
  if (isMapped)
  {
    MapRefinement refinement(rings, vertices);
    isMapped = refinement.ReturnAll(simplification, returned);
    if (isMapped)
    {
      SweepLast(report, refinement);
    }
  }
  if (isCancelled)
  {
    return Status::Failure(Cancelled);
  }
  return isMapped ? Status::Success() : Status::Failure(Degenerate);
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
