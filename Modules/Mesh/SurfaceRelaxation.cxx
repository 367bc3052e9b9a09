#include "SurfaceRelaxation.h"

#include <cmath>

namespace palpate
{
namespace
{
Vector3 AreaVector(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return (b - a).cross(c - a);
}

// Walks around both points at once, so that the time is that of the one with fewer neighbours.
bool AreJoined(const HalfEdgeMesh& mesh, int one, int other)
{
  int g = mesh.Leaving(one);
  int h = mesh.Leaving(other);
  do
  {
    if (mesh.End(g) == other || mesh.End(h) == one)
    {
      return true;
    }
    g = mesh.Around(g);
    h = mesh.Around(h);
  } while (g != mesh.Leaving(one) && h != mesh.Leaving(other));
  return false;
}

bool HasMoreThanThreeTriangles(const HalfEdgeMesh& mesh, int h)
{
  return mesh.Around(mesh.Around(mesh.Around(h))) != h;
}

class Relaxation
{
public:
  Relaxation(HalfEdgeMesh& mesh, const ReferenceNormals& normals) : Mesh(mesh), Normals(normals) {}

  void FlipEdges()
  {
    for (int h = 0; h < this->Mesh.HalfEdgeLimit(); ++h)
    {
      if (this->Mesh.IsAlive(h) && h < this->Mesh.Twin(h) && this->WantsFlip(h))
      {
        this->Mesh.Flip(h);
      }
    }
  }

  void MovePoints()
  {
    for (int p = 0; p < this->Mesh.PointCount(); ++p)
    {
      if (this->Mesh.Leaving(p) >= 0)
      {
        this->MovePoint(p);
      }
    }
  }

private:
  bool WantsFlip(int h) const
  {
    const int a = this->Mesh.Start(h);
    const int b = this->Mesh.End(h);
    const int c = this->Mesh.Start(this->Mesh.Previous(h));
    const int d = this->Mesh.Start(this->Mesh.Previous(this->Mesh.Twin(h)));
    const Vector3& pa = this->Mesh.Point(a);
    const Vector3& pb = this->Mesh.Point(b);
    const Vector3& pc = this->Mesh.Point(c);
    const Vector3& pd = this->Mesh.Point(d);
    const double cosC = (pa - pc).dot(pb - pc);
    const double cosD = (pa - pd).dot(pb - pd);
    if (cosC >= 0.0 && cosD >= 0.0)
    {
      return false;
    }
    const double sinC = (pa - pc).cross(pb - pc).norm();
    const double sinD = (pa - pd).cross(pb - pd).norm();
    // The sine of the sum, with a margin against flipping back and forth.
    if (cosC * sinD + cosD * sinC >= -1e-3 * (std::abs(cosC) * sinD + std::abs(cosD) * sinC))
    {
      return false;
    }
    return this->FlipKeepsShape(pa, pb, pc, pd) &&
           Alignment(AreaVector(pd, pc, pa), this->Normals.Sum(d, c, a)) >= LeastAlignment &&
           Alignment(AreaVector(pc, pd, pb), this->Normals.Sum(c, d, b)) >= LeastAlignment &&
           HasMoreThanThreeTriangles(this->Mesh, h) &&
           HasMoreThanThreeTriangles(this->Mesh, this->Mesh.Twin(h)) &&
           !AreJoined(this->Mesh, c, d);
  }

  // A flip cuts off or fills the tetrahedron of the four points: only where these are nearly in a
  // plane, 30 degrees between the triangles, is that no loss of shape.
  static bool FlipKeepsShape(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
  {
    return Alignment(AreaVector(a, b, c), AreaVector(b, a, d)) >= 0.75;
  }

  void MovePoint(int p)
  {
    const int first = this->Mesh.Leaving(p);
    const Vector3 here = this->Mesh.Point(p);
    Vector3 boundary = Vector3::Zero();
    Vector3 pull = Vector3::Zero();
    double weight = 0.0;
    int h = first;
    do
    {
      const Vector3 from = this->Mesh.Point(this->Mesh.End(h)) - here;
      const Vector3 to = this->Mesh.Point(this->Mesh.Start(this->Mesh.Previous(h))) - here;
      const Vector3 area = from.cross(to);
      const double size = area.norm();
      boundary += area;
      pull += size * (from + to);
      weight += 3.0 * size;
      h = this->Mesh.Around(h);
    } while (h != first);
    if (!(weight > 0.0) || !(boundary.squaredNorm() > 0.0))
    {
      return;
    }
    pull /= weight;
    pull -= boundary * (pull.dot(boundary) / boundary.squaredNorm());
    if (this->StaysAligned(p, here + pull))
    {
      this->Mesh.Move(p, here + pull);
    }
  }

  bool StaysAligned(int p, const Vector3& to) const
  {
    const int first = this->Mesh.Leaving(p);
    int h = first;
    do
    {
      const int b = this->Mesh.End(h);
      const int c = this->Mesh.Start(this->Mesh.Previous(h));
      const Vector3 across = this->Mesh.Point(c) - this->Mesh.Point(b);
      const Vector3 reference = this->Normals.Sum(p, b, c);
      const double now = Alignment(across.cross(to - this->Mesh.Point(b)), reference);
      if (now < LeastAlignment &&
          now <= Alignment(across.cross(this->Mesh.Point(p) - this->Mesh.Point(b)), reference))
      {
        return false;
      }
      h = this->Mesh.Around(h);
    } while (h != first);
    return true;
  }

  HalfEdgeMesh& Mesh;
  const ReferenceNormals& Normals;
};
} // namespace

void RelaxSurface(HalfEdgeMesh& mesh, const ReferenceNormals& normals, int rounds)
{
  Relaxation relaxation(mesh, normals);
  for (int round = 0; round < rounds; ++round)
  {
    relaxation.FlipEdges();
    relaxation.MovePoints();
  }
}
} // namespace palpate
