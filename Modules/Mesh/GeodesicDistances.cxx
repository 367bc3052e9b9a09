#include "GeodesicDistances.h"

#include "WindowPropagation.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
std::vector<std::vector<int>> TrianglesAround(const IndexedMesh& mesh)
{
  std::vector<std::vector<int>> around(mesh.Points.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (const int point : mesh.Triangles[t])
    {
      around[point].push_back(static_cast<int>(t));
    }
  }
  return around;
}

// The corner of a triangle over which a place is reached best.
int BestCorner(const IndexedMesh& mesh, const std::vector<double>& distances,
               const NearestOnMesh::Result& place)
{
  const std::array<int, 3>& corners = mesh.Triangles[place.Triangle];
  const auto through = [&](int point)
  { return distances[point] + (mesh.Points[point] - place.Point).norm(); };
  return *std::min_element(corners.begin(), corners.end(),
                           [&](int a, int b) { return through(a) < through(b); });
}
} // namespace

Status FindGeodesicDistances(const IndexedMesh& mesh, const NearestOnMesh::Result& from,
                             const KernelProgress& progress, std::vector<double>& distances)
{
  WindowPropagation windows(mesh);
  if (!windows.Run(from, progress))
  {
    return Status::Failure("Cancelled.");
  }
  distances = windows.Distances();
  return Status::Success();
}

std::vector<bool> CorridorBack(const IndexedMesh& mesh, const std::vector<double>& distances,
                               const NearestOnMesh::Result& from)
{
  const std::vector<std::vector<int>> around = TrianglesAround(mesh);
  std::vector<bool> corridor(mesh.Triangles.size());
  corridor[from.Triangle] = true;
  for (int at = BestCorner(mesh, distances, from); at >= 0;)
  {
    int next = -1;
    double steepest = 0.0;
    for (const int triangle : around[at])
    {
      corridor[triangle] = true;
      for (const int point : mesh.Triangles[triangle])
      {
        const double fall = distances[at] - distances[point];
        const double slope = fall / (mesh.Points[point] - mesh.Points[at]).norm();
        if (fall > 0.0 && slope > steepest)
        {
          steepest = slope;
          next = point;
        }
      }
    }
    at = next;
  }
  return corridor;
}
} // namespace palpate
