#include "MeshCrossings.h"

#include "TriangleCrossing.h"
#include "TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double LeastMillimetres = 1e-70; // see ExactSign

bool HasTinyCoordinates(const Vector3& p)
{
  const auto sizes = p.array().abs();
  return ((sizes > 0.0) && (sizes < LeastMillimetres)).any();
}

// Copies the mesh only if there is something to round.
IndexedMesh WithoutTinyCoordinates(const IndexedMesh& mesh)
{
  IndexedMesh rounded = mesh;
  for (Vector3& p : rounded.Points)
  {
    p = (p.array().abs() < LeastMillimetres).select(Vector3::Zero(), p);
  }
  return rounded;
}

Vector3 CenterOfOverlap(const FloatBox& one, const FloatBox& other)
{
  Vector3 center;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    center[static_cast<int>(axis)] = 0.5 * std::max(one.Low[axis], other.Low[axis]) +
                                     0.5 * std::min(one.High[axis], other.High[axis]);
  }
  return center;
}

std::vector<char> FindFlat(const IndexedMesh& mesh)
{
  std::vector<char> isFlat(mesh.Triangles.size());
  std::transform(mesh.Triangles.begin(), mesh.Triangles.end(), isFlat.begin(),
                 [&mesh](const std::array<int, 3>& t)
                 { return AreCollinear(mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]]); });
  return isFlat;
}

void Search(const IndexedMesh& mesh, const TriangleTree& tree, const CrossingLimits& limits,
            MeshCrossings& found)
{
  const std::vector<char> isFlat = FindFlat(mesh);
  found.FlatTriangles = static_cast<int>(std::count(isFlat.begin(), isFlat.end(), 1));
  tree.ForEachOverlap(
      [&](int i, int j)
      {
        const auto [first, second] = std::minmax(tree.Order()[i], tree.Order()[j]);
        if (isFlat[first] != 0 || isFlat[second] != 0 || !TrianglesCross(mesh, first, second))
        {
          return true;
        }
        if (found.Count == limits.Count)
        {
          found.IsComplete = false;
          return false;
        }
        ++found.Count;
        if (found.Pairs.size() < limits.Pairs)
        {
          found.Pairs.push_back({first, second, CenterOfOverlap(tree.Boxes()[i], tree.Boxes()[j])});
        }
        return true;
      });
}
} // namespace

Status FindMeshCrossings(const IndexedMesh& mesh, const CrossingLimits& limits,
                         MeshCrossings& found)
{
  found = {};
  TriangleTree tree;
  if (Status status = TriangleTree::Make(mesh, tree, TriangleTree::TriangleBoxes::Kept);
      !status.IsOk())
  {
    return status;
  }
  const bool hasTiny = std::any_of(mesh.Points.begin(), mesh.Points.end(), HasTinyCoordinates);
  Search(hasTiny ? WithoutTinyCoordinates(mesh) : mesh, tree, limits, found);
  std::sort(found.Pairs.begin(), found.Pairs.end(),
            [](const MeshCrossing& one, const MeshCrossing& other)
            { return std::pair(one.First, one.Second) < std::pair(other.First, other.Second); });
  return Status::Success();
}
} // namespace palpate
