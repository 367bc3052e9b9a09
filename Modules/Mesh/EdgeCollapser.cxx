#include "EdgeCollapser.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// A new point with more would be the hub of a fan of slivers. It has 4 fewer than both old ones.
constexpr int MostNeighbours = 12;
constexpr int MostOldNeighbours = MostNeighbours + 4;
} // namespace

EdgeCollapser::EdgeCollapser(HalfEdgeMesh& mesh, ReferenceNormals& normals)
    : Mesh(mesh), Normals(normals), Stamps(mesh.PointCount(), 0)
{
}

bool EdgeCollapser::TryCollapse(int h)
{
  if (!this->HasTwoCommonNeighbours(h))
  {
    return false;
  }
  this->CollectWings(h);
  const int kept = this->Mesh.Start(h);
  const int removed = this->Mesh.End(h);
  const Vector3 point = this->NewPoint(kept, removed);
  const Eigen::Vector3f normal = this->Normals.Merged(kept, removed, point);
  if (!this->StaysAligned(point, normal))
  {
    return false;
  }
  this->Mesh.Collapse(h);
  this->Mesh.Move(kept, point);
  this->Normals.Set(kept, normal);
  return true;
}

// The link condition of Dey, Edelsbrunner, Guha and Nekhayev (1999) for closed surfaces.
bool EdgeCollapser::HasTwoCommonNeighbours(int h)
{
  // Stamps of earlier tests are smaller; a test takes one number, and there can be more than 2^31.
  if (this->Stamp == std::numeric_limits<int>::max())
  {
    std::fill(this->Stamps.begin(), this->Stamps.end(), 0);
    this->Stamp = 0;
  }
  ++this->Stamp;
  int count = 0;
  int g = h;
  do
  {
    this->Stamps[this->Mesh.End(g)] = this->Stamp;
    ++count;
    g = this->Mesh.Around(g);
  } while (g != h && count <= MostOldNeighbours);
  int common = 0;
  const int back = this->Mesh.Twin(h);
  g = back;
  do
  {
    common += this->Stamps[this->Mesh.End(g)] == this->Stamp ? 1 : 0;
    ++count;
    g = this->Mesh.Around(g);
  } while (g != back && count <= MostOldNeighbours);
  // In a tetrahedron both ends have 3 neighbours.
  return common == 2 && count > 6 && count <= MostOldNeighbours;
}

void EdgeCollapser::CollectWings(int h)
{
  this->Wings.clear();
  for (const int first : {h, this->Mesh.Twin(h)})
  {
    // Neither the triangle of the edge nor that of its twin.
    const int last = this->Mesh.Twin(first);
    for (int g = this->Mesh.Around(first); this->Mesh.Next(last) != g; g = this->Mesh.Around(g))
    {
      this->Wings.push_back(
          {this->Mesh.End(g), this->Mesh.Start(this->Mesh.Previous(g)), this->Mesh.Start(g)});
    }
  }
}

// The volume between the new point and the boundary of the changed triangles is linear in it. The
// two triangles that vanish contain the midpoint and do not count.
Vector3 EdgeCollapser::NewPoint(int kept, int removed) const
{
  const Vector3& a = this->Mesh.Point(kept);
  const Vector3& b = this->Mesh.Point(removed);
  const Vector3 middle = 0.5 * (a + b);
  const Vector3 half = 0.5 * (a - b);
  Vector3 area = Vector3::Zero();
  double volume = 0.0;
  for (const Wing& wing : this->Wings)
  {
    const Vector3 part =
        (this->Mesh.Point(wing.From) - middle).cross(this->Mesh.Point(wing.To) - middle);
    area += part;
    volume += (wing.Old == kept ? 1.0 : -1.0) * part.dot(half);
  }
  const Vector3 shift = area * (volume / area.squaredNorm());
  // Around a spike the area nearly vanishes.
  return shift.squaredNorm() <= half.squaredNorm() ? Vector3(middle + shift) : middle;
}

bool EdgeCollapser::StaysAligned(const Vector3& point, const Eigen::Vector3f& normal) const
{
  for (const Wing& wing : this->Wings)
  {
    const Vector3& from = this->Mesh.Point(wing.From);
    const Vector3 across = this->Mesh.Point(wing.To) - from;
    const Vector3 reference =
        (this->Normals.At(wing.From) + this->Normals.At(wing.To) + normal).cast<double>();
    const double now = Alignment(across.cross(point - from), reference);
    if (now < LeastAlignment &&
        now <= Alignment(across.cross(this->Mesh.Point(wing.Old) - from), reference))
    {
      return false;
    }
  }
  return true;
}
} // namespace palpate
