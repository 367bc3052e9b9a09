#include "WindingMesh.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
std::vector<Eigen::AlignedBox3d> BoxesOf(const std::vector<Vector3>& points,
                                         const std::vector<WindingMesh::Triangle>& triangles)
{
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
  {
    Eigen::AlignedBox3d box(points[static_cast<std::size_t>(a)]);
    box.extend(points[static_cast<std::size_t>(b)]);
    box.extend(points[static_cast<std::size_t>(c)]);
    boxes.push_back(box);
  }
  return boxes;
}

// Whether the segment `from` + s `path`, 0 <= s <= 1, meets the box.
bool Meets(const Eigen::AlignedBox3d& box, const Vector3& from, const Vector3& path) noexcept
{
  double first = 0.0;
  double last = 1.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const double inverse = 1.0 / path[axis];
    const double one = (box.min()[axis] - from[axis]) * inverse;
    const double other = (box.max()[axis] - from[axis]) * inverse;
    // A segment along the box's face gives not-a-number, which changes nothing.
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
  }
  return first <= last;
}
} // namespace

WindingMesh::WindingMesh(std::vector<Vector3> pointsWorld, std::vector<Triangle> triangles)
    : Points(std::move(pointsWorld)), Boxes(BoxesOf(Points, triangles))
{
  this->Triangles.reserve(triangles.size());
  for (const std::uint32_t index : this->Boxes.Order())
  {
    this->Triangles.push_back(triangles[index]);
  }
}

int WindingMesh::WindingNumber(const Vector3& pointWorld) const noexcept
{
  const Eigen::AlignedBox3d& all = this->Boxes.Nodes().front().Box;
  if (!all.contains(pointWorld))
  {
    return 0;
  }
  // Along no axis or symmetry plane of any usual shape.
  const std::array<Vector3, 3> directions{
      Vector3(0.8123, 0.3471, 0.4689), {-0.2917, 0.9013, -0.3201}, {0.1309, -0.4817, -0.8665}};
  const double beyond = 2.0 * all.diagonal().norm();
  std::array<int, 3> windings{};
  for (std::size_t i = 0; i < windings.size(); ++i)
  {
    const Vector3 end = pointWorld + beyond * directions[i];
    windings[i] = -this->CrossingsOf(pointWorld, end);
  }
  std::sort(windings.begin(), windings.end());
  return windings[1];
}

// The crossings of a segment from outside of the mesh's front to its back (+1) or the other way
// (-1), together.
int WindingMesh::CrossingsOf(const Vector3& from, const Vector3& to) const noexcept
{
  const Vector3 path = to - from;
  const auto& nodes = this->Boxes.Nodes();
  std::array<std::size_t, BoxHierarchy::MostPending> pending;
  std::size_t count = 0;
  pending[count++] = 0;
  int crossings = 0;
  while (count > 0)
  {
    const std::size_t index = pending[--count];
    const BoxHierarchy::Node& node = nodes[index];
    if (!Meets(node.Box, from, path))
    {
      continue;
    }
    if (node.Count == 0)
    {
      pending[count++] = static_cast<std::size_t>(node.Second);
      pending[count++] = index + 1;
      continue;
    }
    for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
    {
      crossings += this->CrossingOf(from, to, this->Triangles[static_cast<std::size_t>(i)]);
    }
  }
  return crossings;
}

// By the signs of five volumes (Moeller and Trumbore, "Fast, minimum storage ray/triangle
// intersection", J. Graphics Tools 2, 1997, tests the same).
int WindingMesh::CrossingOf(const Vector3& from, const Vector3& to,
                            const Triangle& triangle) const noexcept
{
  const Vector3 a = this->Points[static_cast<std::size_t>(triangle[0])] - from;
  const Vector3 b = this->Points[static_cast<std::size_t>(triangle[1])] - from;
  const Vector3 c = this->Points[static_cast<std::size_t>(triangle[2])] - from;
  const Vector3 path = to - from;
  const Vector3 normal = (b - a).cross(c - a);
  const double height = normal.dot(a);
  const double reach = normal.dot(path);
  if (!(height * reach >= 0.0 && std::abs(height) <= std::abs(reach) && reach != 0.0))
  {
    return 0;
  }
  const double first = path.dot(a.cross(b));
  const double second = path.dot(b.cross(c));
  const double third = path.dot(c.cross(a));
  const bool isThrough = (first >= 0.0 && second >= 0.0 && third >= 0.0) ||
                         (first <= 0.0 && second <= 0.0 && third <= 0.0);
  return isThrough ? (reach < 0.0 ? 1 : -1) : 0;
}
} // namespace palpate
