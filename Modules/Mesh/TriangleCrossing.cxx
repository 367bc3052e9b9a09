#include "TriangleCrossing.h"

#include "ExactSign.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
using exact::AreaSign;
using exact::Plane;
using exact::Point2;
using exact::VolumeSign;

// A triangle's corners; common corners first.
using CrossingCorners = std::array<const Vector3*, 3>;

Point2 Project(const Vector3& point, int axis) noexcept
{
  return {point[(axis + 1) % 3], point[(axis + 2) % 3]};
}

bool RangesMeet(double a, double b, double c, double d) noexcept
{
  return std::min(a, b) <= std::max(c, d) && std::min(c, d) <= std::max(a, b);
}

bool SegmentsMeet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) noexcept
{
  return RangesMeet(a[0], b[0], c[0], d[0]) && RangesMeet(a[1], b[1], c[1], d[1]) &&
         AreaSign(a, b, c) * AreaSign(a, b, d) <= 0 && AreaSign(c, d, a) * AreaSign(c, d, b) <= 0;
}

// Whether no two of three signs are opposite.
bool AgreeInSign(int a, int b, int c) noexcept
{
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

// An axis along which a triangle's projection has an area.
int AxisOfProjection(const CrossingCorners& t) noexcept
{
  int axis = 0;
  while (axis < 2 &&
         AreaSign(Project(*t[0], axis), Project(*t[1], axis), Project(*t[2], axis)) == 0)
  {
    ++axis;
  }
  return axis;
}

// A segment in the plane of a triangle.
bool MeetsInPlane(const Vector3& from, const Vector3& to, const CrossingCorners& t) noexcept
{
  const int axis = AxisOfProjection(t);
  const Point2 p = Project(from, axis);
  const Point2 q = Project(to, axis);
  const Point2 a = Project(*t[0], axis);
  const Point2 b = Project(*t[1], axis);
  const Point2 c = Project(*t[2], axis);
  return AgreeInSign(AreaSign(a, b, p), AreaSign(b, c, p), AreaSign(c, a, p)) ||
         SegmentsMeet(p, q, a, b) || SegmentsMeet(p, q, b, c) || SegmentsMeet(p, q, c, a);
}

// A segment whose ends are on the given sides of a triangle's plane.
bool SegmentMeets(const Vector3& from, const Vector3& to, int fromSide, int toSide,
                  const CrossingCorners& t) noexcept
{
  if (fromSide * toSide > 0)
  {
    return false;
  }
  if (fromSide == 0 && toSide == 0)
  {
    return MeetsInPlane(from, to, t);
  }
  const Plane line(from, to, *t[0]);
  return AgreeInSign(line.SideOf(*t[1]), VolumeSign(from, to, *t[1], *t[2]), -line.SideOf(*t[2]));
}

bool EdgesMeet(const CrossingCorners& edges, const std::array<int, 3>& sides,
               const CrossingCorners& t) noexcept
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    if (SegmentMeets(*edges[i], *edges[j], sides[i], sides[j], t))
    {
      return true;
    }
  }
  return false;
}

std::array<int, 3> SidesOf(const Plane& plane, const CrossingCorners& t) noexcept
{
  return {plane.SideOf(*t[0]), plane.SideOf(*t[1]), plane.SideOf(*t[2])};
}

bool CrossApart(const CrossingCorners& t, const CrossingCorners& u) noexcept
{
  const std::array<int, 3> uSides = SidesOf(Plane(*t[0], *t[1], *t[2]), u);
  if (uSides[0] != 0 && uSides[0] == uSides[1] && uSides[1] == uSides[2])
  {
    return false;
  }
  const std::array<int, 3> tSides = SidesOf(Plane(*u[0], *u[1], *u[2]), t);
  if (tSides[0] != 0 && tSides[0] == tSides[1] && tSides[1] == tSides[2])
  {
    return false;
  }
  return EdgesMeet(u, uSides, t) || EdgesMeet(t, tSides, u);
}

// Another common point lies on a ray from the common corner that leaves one triangle through its
// opposite edge while still in the other.
bool CrossAtCorner(const CrossingCorners& t, const CrossingCorners& u) noexcept
{
  const Plane tPlane(*t[0], *t[1], *t[2]);
  const int u1 = tPlane.SideOf(*u[1]);
  const int u2 = tPlane.SideOf(*u[2]);
  if (u1 * u2 > 0)
  {
    return false;
  }
  const Plane uPlane(*u[0], *u[1], *u[2]);
  const int t1 = uPlane.SideOf(*t[1]);
  const int t2 = uPlane.SideOf(*t[2]);
  return t1 * t2 <= 0 &&
         (SegmentMeets(*u[1], *u[2], u1, u2, t) || SegmentMeets(*t[1], *t[2], t1, t2, u));
}

// In one plane and on the same side of the common edge.
bool CrossAtEdge(const CrossingCorners& t, const CrossingCorners& u) noexcept
{
  if (VolumeSign(*t[0], *t[1], *t[2], *u[2]) != 0)
  {
    return false;
  }
  const int axis = AxisOfProjection(t);
  const Point2 a = Project(*t[0], axis);
  const Point2 b = Project(*t[1], axis);
  return AreaSign(a, b, Project(*t[2], axis)) == AreaSign(a, b, Project(*u[2], axis));
}

// Swaps common corners to the front, in the same order; returns their number.
int BringCommonForward(std::array<int, 3>& t, std::array<int, 3>& u) noexcept
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto found = std::find(u.begin() + static_cast<std::ptrdiff_t>(count), u.end(), t[i]);
    if (found != u.end())
    {
      std::swap(u[count], *found);
      std::swap(t[count], t[i]);
      ++count;
    }
  }
  return static_cast<int>(count);
}
} // namespace

bool AreCollinear(const Vector3& a, const Vector3& b, const Vector3& c) noexcept
{
  const auto isThin = [&](int axis)
  { return AreaSign(Project(a, axis), Project(b, axis), Project(c, axis)) == 0; };
  return isThin(0) && isThin(1) && isThin(2);
}

bool TrianglesCross(const IndexedMesh& mesh, int one, int other) noexcept
{
  std::array<int, 3> t = mesh.Triangles[one];
  std::array<int, 3> u = mesh.Triangles[other];
  const int common = BringCommonForward(t, u);
  const auto corners = [&mesh](const std::array<int, 3>& triangle)
  {
    return CrossingCorners{&mesh.Points[triangle[0]], &mesh.Points[triangle[1]],
                           &mesh.Points[triangle[2]]};
  };
  switch (common)
  {
  case 0:
    return CrossApart(corners(t), corners(u));
  case 1:
    return CrossAtCorner(corners(t), corners(u));
  case 2:
    return CrossAtEdge(corners(t), corners(u));
  default:
    return true;
  }
}
} // namespace palpate
