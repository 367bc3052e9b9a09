#include "NearestOnMesh.h"

#include "NearestKernel.h"
#include "SpatialOrder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace palpate::nearest
{
namespace
{
struct PortableSet
{
  typedef double Vector __attribute__((vector_size(16)));
  typedef long long Integers __attribute__((vector_size(16)));
  static constexpr int Lanes = 2;

  static inline __attribute__((always_inline)) bool Any(const Integers& lanes)
  {
    return (lanes[0] | lanes[1]) != 0;
  }
};

const Kernel Portable{Arithmetic<PortableSet>::Find};

const Kernel& KernelFor(InstructionSet set) noexcept
{
  return set == InstructionSet::Avx2 ? Avx2 : Portable;
}
} // namespace
} // namespace palpate::nearest

namespace palpate
{
namespace
{
// A part of the tree that may hold something nearer than its square of a distance.
struct PendingNode
{
  int Node;
  double Square;
};

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
  TriangleTree tree;
  if (Status status = TriangleTree::Make(mesh, tree); !status.IsOk())
  {
    return status;
  }
  made.Order = tree.Order();
  made.Nodes = std::move(tree).TakeNodes();
  made.Arrange(mesh);
  for (Corners& corners : made.Triangles)
  {
    corners = made.IsFlat(corners) ? made.Segment(corners) : corners;
  }
  return Status::Success();
}

// Close points follow each other, so that queries find them together.
void NearestOnMesh::Arrange(const IndexedMesh& mesh)
{
  constexpr int None = -1;
  std::vector<int> placeOf(mesh.Points.size(), None);
  this->Points.clear();
  this->Points.reserve(mesh.Points.size());
  const auto add = [&](int point)
  {
    if (placeOf[point] == None)
    {
      placeOf[point] = static_cast<int>(this->Points.size());
      this->Points.push_back(mesh.Points[point]);
    }
    return placeOf[point];
  };
  this->Triangles.resize(mesh.Triangles.size());
  this->Places.resize(mesh.Triangles.size());
  for (std::size_t place = 0; place < this->Order.size(); ++place)
  {
    const std::array<int, 3>& t = mesh.Triangles[this->Order[place]];
    this->Triangles[place] = {add(t[0]), add(t[1]), add(t[2])};
    this->Places[this->Order[place]] = static_cast<int>(place);
  }
}

bool NearestOnMesh::IsFlat(const Corners& corners) const
{
  const Vector3 ab = this->Points[corners[1]] - this->Points[corners[0]];
  const Vector3 ac = this->Points[corners[2]] - this->Points[corners[0]];
  return !(ab.cross(ac).norm() > 1e-12 * ab.norm() * ac.norm());
}

// The longest edge, in a form for which NearestOnTriangle divides by no rounding error.
NearestOnMesh::Corners NearestOnMesh::Segment(const Corners& flat) const
{
  const auto& [a, b, c] = flat;
  const double ab = (this->Points[b] - this->Points[a]).squaredNorm();
  const double bc = (this->Points[c] - this->Points[b]).squaredNorm();
  const double ca = (this->Points[a] - this->Points[c]).squaredNorm();
  if (ab >= bc && ab >= ca)
  {
    return {a, b, b};
  }
  return bc >= ca ? Corners{b, c, c} : Corners{c, a, a};
}

NearestOnMesh::Result NearestOnMesh::FindFrom(const Vector3& point, int start) const noexcept
{
  Result result;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](int place)
  {
    const Corners& t = this->Triangles[place];
    const Vector3 nearest =
        NearestOnTriangle(point, this->Points[t[0]], this->Points[t[1]], this->Points[t[2]]);
    const double square = (nearest - point).squaredNorm();
    if (square < least)
    {
      least = square;
      result.Point = nearest;
      result.Triangle = place;
    }
  };
  consider(this->Places[start]);
  std::array<PendingNode, TriangleTree::MostPending> pending;
  int count = 0;
  int at = 0;
  for (;;)
  {
    const TriangleTree::Node& node = this->Nodes[at];
    if (node.Count == 0)
    {
      PendingNode near{at + 1, DistanceToBox(point, this->Nodes[at + 1].Box)};
      PendingNode far{node.Second, DistanceToBox(point, this->Nodes[node.Second].Box)};
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
  result.Triangle = this->Order[result.Triangle];
  return result;
}

void NearestOnMesh::Search(const std::vector<Vector3>& points, InstructionSet set,
                           std::vector<double>& squares, std::vector<int>& places) const
{
  using Node = TriangleTree::Node;
  static_assert(sizeof(Node) == sizeof(nearest::Node) &&
                nearest::MostPending >= TriangleTree::MostPending &&
                offsetof(Node, Second) == offsetof(nearest::Node, Second) &&
                offsetof(Node, Count) == offsetof(nearest::Node, Count));
  static_assert(sizeof(Corners) == 3 * sizeof(int) && sizeof(Vector3) == 3 * sizeof(double));
  squares.resize(points.size());
  places.resize(points.size());
  if (points.empty())
  {
    return;
  }
  const nearest::Mesh mesh{reinterpret_cast<const nearest::Node*>(this->Nodes.data()),
                           this->Triangles.front().data(), this->Points.front().data()};
  const std::vector<int> order = SpatialOrder(points);
  std::vector<Vector3> queries;
  queries.reserve(points.size());
  std::transform(order.begin(), order.end(), std::back_inserter(queries),
                 [&points](int number) { return points[number]; });
  std::vector<double> squaresInOrder(points.size());
  std::vector<int> placesInOrder(points.size());
  nearest::KernelFor(set).Find(mesh, queries.front().data(), static_cast<long>(points.size()),
                               squaresInOrder.data(), placesInOrder.data());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    squares[order[i]] = squaresInOrder[i];
    places[order[i]] = placesInOrder[i];
  }
}

std::vector<NearestOnMesh::Result> NearestOnMesh::FindAll(const std::vector<Vector3>& points,
                                                          InstructionSet set) const
{
  std::vector<double> squares;
  std::vector<int> places;
  this->Search(points, set, squares, places);
  std::vector<Result> results(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Corners& t = this->Triangles[places[i]];
    const Vector3 nearest =
        NearestOnTriangle(points[i], this->Points[t[0]], this->Points[t[1]], this->Points[t[2]]);
    results[i] = {nearest, (nearest - points[i]).norm(), this->Order[places[i]]};
  }
  return results;
}

std::vector<double> NearestOnMesh::DistancesOf(const std::vector<Vector3>& points,
                                               InstructionSet set) const
{
  std::vector<double> squares;
  std::vector<int> places;
  this->Search(points, set, squares, places);
  std::transform(squares.begin(), squares.end(), squares.begin(),
                 [](double square) { return std::sqrt(square); });
  return squares;
}
} // namespace palpate
