#include "MeshGap.h"

#include "NearestOnMesh.h"
#include "TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>

namespace palpate
{
namespace
{
using Corners = std::array<Vector3, 3>;

// Two nodes of the trees, and a distance that their triangles exceed.
struct NodePair
{
  double Least; // squared
  int One;
  int Other;
  std::size_t Number; // of those that were found
  // The nearest first; of boxes that overlap the newest, which leads to triangles soonest.
  bool operator<(const NodePair& pair) const noexcept
  {
    return this->Least > pair.Least || (this->Least == pair.Least && this->Number < pair.Number);
  }
};

double SquaredGap(const FloatBox& one, const FloatBox& other) noexcept
{
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double above = double{other.Low[axis]} - double{one.High[axis]};
    const double below = double{one.Low[axis]} - double{other.High[axis]};
    const double out = std::max({above, below, 0.0});
    sum += out * out;
  }
  return sum;
}

double Extent(const FloatBox& box) noexcept
{
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    sum += double{box.High[axis]} - double{box.Low[axis]};
  }
  return sum;
}

Corners CornersOf(const IndexedMesh& mesh, int triangle)
{
  const auto [a, b, c] = mesh.Triangles[triangle];
  return {mesh.Points[a], mesh.Points[b], mesh.Points[c]};
}

void Offer(MeshGap& gap, const Vector3& one, const Vector3& other)
{
  const double distance = (one - other).norm();
  if (distance < gap.Distance)
  {
    gap = {one, other, distance};
  }
}

// The nearest points of two segments (Ericson, Real-Time Collision Detection, 2005, 5.1.9).
void OfferSegments(MeshGap& gap, const Vector3& p, const Vector3& q, const Vector3& r,
                   const Vector3& s)
{
  const Vector3 first = q - p;
  const Vector3 second = s - r;
  const Vector3 between = p - r;
  const double a = first.squaredNorm();
  const double e = second.squaredNorm();
  if (a == 0.0 || e == 0.0)
  {
    return; // points, which are compared with triangles
  }
  const double b = first.dot(second);
  const double c = first.dot(between);
  const double f = second.dot(between);
  const double determinant = a * e - b * b;
  double along = determinant > 0.0 ? std::clamp((b * f - c * e) / determinant, 0.0, 1.0) : 0.0;
  const double there = std::clamp((b * along + f) / e, 0.0, 1.0);
  along = std::clamp((b * there - c) / a, 0.0, 1.0);
  Offer(gap, p + along * first, r + there * second);
}

// Where a segment crosses a triangle, the distance is 0. Touching is found by the other tests.
void OfferCrossing(MeshGap& gap, const Vector3& p, const Vector3& q, const Corners& t)
{
  const Vector3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double above = normal.dot(p - t[0]);
  const double below = normal.dot(q - t[0]);
  if (above * below >= 0.0)
  {
    return;
  }
  const Vector3 point = p + (above / (above - below)) * (q - p);
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (normal.dot((t[(k + 1) % 3] - t[k]).cross(point - t[k])) < 0.0)
    {
      return;
    }
  }
  gap = {point, point, 0.0};
}

// Whether the boxes of two triangles are apart by as much as a distance: most of two leaves are.
bool AreApart(const Corners& one, const Corners& other, double distance)
{
  const Vector3 low = one[0].cwiseMin(one[1]).cwiseMin(one[2]);
  const Vector3 high = one[0].cwiseMax(one[1]).cwiseMax(one[2]);
  const Vector3 otherLow = other[0].cwiseMin(other[1]).cwiseMin(other[2]);
  const Vector3 otherHigh = other[0].cwiseMax(other[1]).cwiseMax(other[2]);
  const Vector3 between = (low - otherHigh).cwiseMax(otherLow - high).cwiseMax(0.0);
  return between.squaredNorm() > distance * distance;
}

void OfferTriangles(MeshGap& gap, const Corners& one, const Corners& other)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& p = one[i];
    const Vector3& q = one[(i + 1) % 3];
    Offer(gap, p, NearestOnTriangle(p, other[0], other[1], other[2]));
    Offer(gap, NearestOnTriangle(other[i], one[0], one[1], one[2]), other[i]);
    OfferCrossing(gap, p, q, other);
    OfferCrossing(gap, other[i], other[(i + 1) % 3], one);
    for (std::size_t j = 0; j < 3; ++j)
    {
      OfferSegments(gap, p, q, other[j], other[(j + 1) % 3]);
    }
  }
}

// Visits the pairs of nodes from the nearest on, until none can be nearer than what was found.
class GapSearch
{
public:
  GapSearch(const IndexedMesh& one, const IndexedMesh& other, const TriangleTree& treeOfOne,
            const TriangleTree& treeOfOther)
      : One(one), Other(other), TreeOfOne(treeOfOne), TreeOfOther(treeOfOther)
  {
  }

  MeshGap Find()
  {
    this->Gap.Distance = std::numeric_limits<double>::infinity();
    this->Add(0, 0);
    while (!this->Open.empty() && this->Open.top().Least < this->Gap.Distance * this->Gap.Distance)
    {
      const NodePair pair = this->Open.top();
      this->Open.pop();
      this->Visit(pair.One, pair.Other);
    }
    return this->Gap;
  }

private:
  void Add(int one, int other)
  {
    const double least =
        SquaredGap(this->TreeOfOne.Nodes()[one].Box, this->TreeOfOther.Nodes()[other].Box);
    if (least < this->Gap.Distance * this->Gap.Distance)
    {
      this->Open.push({least, one, other, this->Count++});
    }
  }

  void Visit(int i, int j)
  {
    const TriangleTree::Node& one = this->TreeOfOne.Nodes()[i];
    const TriangleTree::Node& other = this->TreeOfOther.Nodes()[j];
    if (one.Count != 0 && other.Count != 0)
    {
      this->CompareLeaves(one, other);
    }
    else if (other.Count != 0 || (one.Count == 0 && Extent(one.Box) > Extent(other.Box)))
    {
      this->Add(i + 1, j);
      this->Add(one.Second, j);
    }
    else
    {
      this->Add(i, j + 1);
      this->Add(i, other.Second);
    }
  }

  void CompareLeaves(const TriangleTree::Node& one, const TriangleTree::Node& other)
  {
    for (int i = one.Second; i < one.Second + one.Count; ++i)
    {
      const Corners corners = CornersOf(this->One, this->TreeOfOne.Order()[i]);
      for (int j = other.Second; j < other.Second + other.Count; ++j)
      {
        const Corners others = CornersOf(this->Other, this->TreeOfOther.Order()[j]);
        if (!AreApart(corners, others, this->Gap.Distance))
        {
          OfferTriangles(this->Gap, corners, others);
        }
      }
    }
  }

  const IndexedMesh& One;
  const IndexedMesh& Other;
  const TriangleTree& TreeOfOne;
  const TriangleTree& TreeOfOther;
  std::priority_queue<NodePair> Open;
  std::size_t Count = 0;
  MeshGap Gap;
};
} // namespace

Status GapSurface::Make(const IndexedMesh& mesh, GapSurface& made)
{
  made.Mesh = &mesh;
  return TriangleTree::Make(mesh, made.Tree);
}

MeshGap GapSurface::To(const GapSurface& other) const
{
  return GapSearch(*this->Mesh, *other.Mesh, this->Tree, other.Tree).Find();
}

Status FindMeshGap(const IndexedMesh& one, const IndexedMesh& other, MeshGap& gap)
{
  GapSurface here;
  GapSurface there;
  Status status = GapSurface::Make(one, here);
  if (status.IsOk())
  {
    status = GapSurface::Make(other, there);
  }
  if (status.IsOk())
  {
    gap = here.To(there);
  }
  return status;
}
} // namespace palpate
