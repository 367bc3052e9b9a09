#include "MeshRays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr double Nowhere = std::numeric_limits<double>::infinity();

// Where a ray enters a box, from 0; Nowhere if it misses the box.
double EntryInto(const FloatBox& box, const Vector3& point, const Vector3& inverse)
{
  double from = 0.0;
  double to = Nowhere;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto place = static_cast<std::size_t>(axis);
    const double low = (static_cast<double>(box.Low[place]) - point[axis]) * inverse[axis];
    const double high = (static_cast<double>(box.High[place]) - point[axis]) * inverse[axis];
    from = std::fmax(from, std::fmin(low, high)); // a ray in a face has NaN, which does not count
    to = std::fmin(to, std::fmax(low, high));
  }
  return from <= to ? from : Nowhere;
}

// Along the ray, Nowhere beside the triangle (Moeller and Trumbore, "Fast, minimum storage
// ray/triangle intersection", 1997). Edges belong to both triangles, so that no ray slips through.
double MeetingWith(const std::array<Vector3, 3>& corners, const Vector3& point,
                   const Vector3& direction)
{
  constexpr double Slack = 1e-9; // of the triangle
  const Vector3 one = corners[1] - corners[0];
  const Vector3 other = corners[2] - corners[0];
  const Vector3 across = direction.cross(other);
  const double determinant = one.dot(across);
  if (determinant == 0.0)
  {
    return Nowhere;
  }
  const Vector3 from = point - corners[0];
  const Vector3 normal = from.cross(one);
  const double u = from.dot(across) / determinant;
  const double v = direction.dot(normal) / determinant;
  const bool isIn = u >= -Slack && v >= -Slack && u + v <= 1.0 + Slack;
  const double distance = other.dot(normal) / determinant;
  return isIn && distance >= 0.0 ? distance : Nowhere;
}
} // namespace

Status MeshRays::Make(const IndexedMesh& mesh, MeshRays& made)
{
  made.Mesh = &mesh;
  return TriangleTree::Make(mesh, made.Tree);
}

double MeshRays::ExitFrom(const Vector3& point, const Vector3& direction, int own) const
{
  const Vector3 inverse = direction.cwiseInverse();
  double nearest = Nowhere;
  bool isExit = false;
  const auto meet = [&](int triangle)
  {
    const std::array<int, 3>& t = this->Mesh->Triangles[triangle];
    const std::array<Vector3, 3> corners{this->Mesh->Points[t[0]], this->Mesh->Points[t[1]],
                                         this->Mesh->Points[t[2]]};
    const bool isOwn = std::find(t.begin(), t.end(), own) != t.end();
    const double distance = isOwn ? Nowhere : MeetingWith(corners, point, direction);
    if (distance < nearest)
    {
      nearest = distance;
      isExit = (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(direction) > 0.0;
    }
  };
  const std::vector<TriangleTree::Node>& nodes = this->Tree.Nodes();
  std::array<int, TriangleTree::MostPending> pending{};
  int count = 1; // the root
  while (count > 0)
  {
    const int at = pending[--count];
    const TriangleTree::Node& node = nodes[at];
    if (!(EntryInto(node.Box, point, inverse) < nearest))
    {
      continue;
    }
    for (int place = node.Second; place < node.Second + node.Count; ++place)
    {
      meet(this->Tree.Order()[place]);
    }
    if (node.Count == 0)
    {
      pending[count++] = node.Second;
      pending[count++] = at + 1;
    }
  }
  return isExit ? nearest : std::numeric_limits<double>::quiet_NaN();
}
} // namespace palpate
