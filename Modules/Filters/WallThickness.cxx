#include "WallThickness.h"

#include "DirectionCaster.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double LeastCosine = 0.75; // of normals on one side of an edge

// Of each corner of a triangle: the normals around it up to sharp edges, weighted by their angles.
std::array<Vector3, 3> CornerNormals(const IndexedMesh& mesh, int triangle)
{
  const std::array<int, 3>& corners = mesh.Triangles[triangle];
  const Vector3 own = AreaVector(mesh, corners).normalized();
  std::array<Vector3, 3> normals{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto found = std::find(corners.begin(), corners.end(), t[k]);
      const Vector3 normal = AreaVector(mesh, t).normalized();
      if (found != corners.end() && normal.dot(own) >= LeastCosine)
      {
        normals[static_cast<std::size_t>(found - corners.begin())] +=
            CornerAngle(mesh, t, k) * normal;
      }
    }
  }
  return normals;
}

// Weights of a triangle's corners at a point of it: the areas opposite of them.
Vector3 NormalAt(const IndexedMesh& mesh, int triangle, const Vector3& point)
{
  const auto [a, b, c] = mesh.Triangles[triangle];
  const std::array<Vector3, 3> arms{mesh.Points[a] - point, mesh.Points[b] - point,
                                    mesh.Points[c] - point};
  const std::array<Vector3, 3> normals = CornerNormals(mesh, triangle);
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 0; k < 3; ++k)
  {
    sum += arms[(k + 1) % 3].cross(arms[(k + 2) % 3]).norm() * normals[k].normalized();
  }
  return sum.normalized();
}

// Distance of the next crossing if the ray starts inwards; else 0.
double NextCrossing(const IndexedMesh& mesh, const Vector3& point, const Vector3& direction)
{
  constexpr double LeastDistance = 1e-6; // mm: the surface where the ray starts
  const std::vector<RayCrossing> crossings = DirectionCaster({direction}).Cast(mesh, point).front();
  const auto next =
      std::find_if(crossings.begin(), crossings.end(),
                   [](const RayCrossing& crossing) { return crossing.Distance > LeastDistance; });
  return (crossings.end() - next) % 2 == 1 ? next->Distance : 0.0;
}
} // namespace

Status MeasureThickness(const IndexedMesh& mesh, const NearestOnMesh& nearest, const Vector3& point,
                        WallThickness& measured)
{
  const NearestOnMesh::Result start = nearest.Find(point);
  const Vector3 outwards = NormalAt(mesh, start.Triangle, start.Point);
  for (const Vector3& inwards : {Vector3(-outwards), outwards})
  {
    const double thickness = NextCrossing(mesh, start.Point, inwards);
    if (thickness > 0.0)
    {
      measured = {start.Point, start.Point + thickness * inwards, thickness};
      return Status::Success();
    }
  }
  return Status::Failure("The surface has no opposite wall here: it is not closed.");
}
} // namespace palpate
