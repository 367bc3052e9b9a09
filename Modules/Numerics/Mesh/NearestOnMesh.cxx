#include "NearestOnMesh.h"

#include "NearestKernelChoice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
// Squared. Single precision would need margins, and is not faster here.
double DistanceToBox(const Vector3& p, const FloatBox& box) noexcept
{
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = static_cast<double>(box.Low[axis]) - p[axis];
    const double high = p[axis] - static_cast<double>(box.High[axis]);
    const double out = std::max({low, high, 0.0});
    sum += out * out;
  }
  return sum;
}
} // namespace

Vector3 NearestOnTriangle(const Vector3& point, const Vector3& a, const Vector3& b,
                          const Vector3& c) noexcept
{
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Vector3 ap = point - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return a;
  }
  const Vector3 bp = point - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return b;
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    return a + (d1 / (d1 - d3)) * ab;
  }
  const Vector3 cp = point - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return c;
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    return a + (d2 / (d2 - d6)) * ac;
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6)
  {
    return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  }
  const double scale = 1.0 / (va + vb + vc);
  return a + (vb * scale) * ab + (vc * scale) * ac;
}

Status NearestOnMesh::Make(const IndexedMesh& mesh, NearestOnMesh& made)
{
  if (Status status = TriangleTree::Make(mesh, made.Tree); !status.IsOk())
  {
    return status;
  }
  made.Triangles.clear();
  made.Triangles.reserve(mesh.Triangles.size());
  for (const int number : made.Tree.Order())
  {
    const std::array<int, 3>& t = mesh.Triangles[number];
    const Corners corners{mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]]};
    const Vector3 ab = corners.B - corners.A;
    const Vector3 ac = corners.C - corners.A;
    const bool isFlat = !(ab.cross(ac).norm() > 1e-12 * ab.norm() * ac.norm());
    made.Triangles.push_back(isFlat ? Segment(corners) : corners);
  }
  made.Places.resize(mesh.Triangles.size());
  for (std::size_t place = 0; place < made.Places.size(); ++place)
  {
    made.Places[made.Tree.Order()[place]] = static_cast<int>(place);
  }
  return Status::Success();
}

// The longest edge, in a form for which NearestOnTriangle divides by no rounding error.
NearestOnMesh::Corners NearestOnMesh::Segment(const Corners& flat)
{
  const double ab = (flat.B - flat.A).squaredNorm();
  const double bc = (flat.C - flat.B).squaredNorm();
  const double ca = (flat.A - flat.C).squaredNorm();
  if (ab >= bc && ab >= ca)
  {
    return {flat.A, flat.B, flat.B};
  }
  return bc >= ca ? Corners{flat.B, flat.C, flat.C} : Corners{flat.C, flat.A, flat.A};
}

NearestOnMesh::Result NearestOnMesh::FindFrom(const Vector3& point, int start) const noexcept
{
  struct Pending
  {
    int Node;
    double Square;
  };
  Result result;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](int place)
  {
    const Corners& t = this->Triangles[place];
    const Vector3 nearest = NearestOnTriangle(point, t.A, t.B, t.C);
    const double square = (nearest - point).squaredNorm();
    if (square < least)
    {
      least = square;
      result.Point = nearest;
      result.Triangle = place;
    }
  };
  consider(this->Places[start]);
  std::array<Pending, TriangleTree::MostPending> pending;
  int count = 0;
  const std::vector<TriangleTree::Node>& nodes = this->Tree.Nodes();
  int at = 0;
  for (;;)
  {
    const TriangleTree::Node& node = nodes[at];
    if (node.Count == 0)
    {
      Pending near{at + 1, DistanceToBox(point, nodes[at + 1].Box)};
      Pending far{node.Second, DistanceToBox(point, nodes[node.Second].Box)};
      if (far.Square < near.Square)
      {
        std::swap(near, far);
      }
      if (far.Square < least)
      {
        pending[count++] = far;
      }
      if (near.Square < least)
      {
        at = near.Node;
        continue;
      }
    }
    for (int i = node.Second; i < node.Second + node.Count; ++i)
    {
      consider(i);
    }
    while (count > 0 && pending[count - 1].Square >= least)
    {
      --count;
    }
    if (count == 0)
    {
      break;
    }
    at = pending[--count].Node;
  }
  result.Distance = std::sqrt(least);
  result.Triangle = this->Tree.Order()[result.Triangle];
  return result;
}

std::vector<double> NearestOnMesh::Distances(const std::vector<Vector3>& points,
                                             const std::vector<int>& order,
                                             InstructionSet set) const
{
  using Node = TriangleTree::Node;
  static_assert(sizeof(Node) == sizeof(nearest::Node) &&
                nearest::MostPending >= TriangleTree::MostPending &&
                offsetof(Node, Second) == offsetof(nearest::Node, Second) &&
                offsetof(Node, Count) == offsetof(nearest::Node, Count));
  static_assert(sizeof(Corners) == 9 * sizeof(double) && sizeof(Vector3) == 3 * sizeof(double));
  std::vector<double> distances(points.size());
  if (points.empty())
  {
    return distances;
  }
  const nearest::Mesh mesh{reinterpret_cast<const nearest::Node*>(this->Tree.Nodes().data()),
                           this->Triangles.front().A.data()};
  nearest::KernelFor(set).Squares(mesh, points.front().data(), order.data(),
                                  static_cast<long>(order.size()), distances.data());
  std::transform(distances.begin(), distances.end(), distances.begin(),
                 [](double square) { return std::sqrt(square); });
  return distances;
}

std::vector<int> NearestOnMesh::PointOrder(const IndexedMesh& mesh, const NearestOnMesh& made)
{
  std::vector<int> order;
  order.reserve(mesh.Points.size());
  std::vector<bool> isListed(mesh.Points.size());
  const auto list = [&](int point)
  {
    if (!isListed[point])
    {
      isListed[point] = true;
      order.push_back(point);
    }
  };
  for (const int triangle : made.Tree.Order())
  {
    for (const int corner : mesh.Triangles[triangle])
    {
      list(corner);
    }
  }
  for (std::size_t point = 0; point < mesh.Points.size(); ++point)
  {
    list(static_cast<int>(point)); // those of no triangle
  }
  return order;
}
} // namespace palpate
