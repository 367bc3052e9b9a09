#pragma once

#include "IcosahedronDirections.h"
#include "IndexedMesh.h"

#include <cmath>

namespace palpate::test
{
/// An inscribed polyhedron with 20 frequency^2 triangles.
inline IndexedMesh Sphere(int frequency, double radius = 1.0,
                          const Vector3& center = Vector3::Zero())
{
  const IcosahedronDirections directions(frequency);
  IndexedMesh mesh{directions.Directions(), directions.Triangles()};
  for (Vector3& p : mesh.Points)
  {
    p = center + radius * p;
  }
  return mesh;
}

/// A torus around z with 2 around across triangles.
inline IndexedMesh Torus(int around, int across, double large = 3.0, double small = 1.0)
{
  IndexedMesh mesh;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double a = 2.0 * M_PI * i / around;
      const double b = 2.0 * M_PI * j / across;
      const double r = large + small * std::cos(b);
      mesh.Points.emplace_back(r * std::cos(a), r * std::sin(a), small * std::sin(b));
      const int next = (i + 1) % around;
      const int up = (j + 1) % across;
      const std::array<int, 4> quad{i * across + j, next * across + j, next * across + up,
                                    i * across + up};
      mesh.Triangles.push_back({quad[0], quad[1], quad[2]});
      mesh.Triangles.push_back({quad[0], quad[2], quad[3]});
    }
  }
  return mesh;
}

/// The box from `low` to `high` with 12 triangles.
inline IndexedMesh Box(const Vector3& low, const Vector3& high)
{
  IndexedMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
  {
    mesh.Points.emplace_back((corner & 1) != 0 ? high[0] : low[0],
                             (corner & 2) != 0 ? high[1] : low[1],
                             (corner & 4) != 0 ? high[2] : low[2]);
  }
  mesh.Triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// A tetrahedron with its first corner at `tip`.
inline IndexedMesh Tetrahedron(const Vector3& tip, double size)
{
  return {{tip, tip + Vector3(size, 0, 0), tip + Vector3(0, size, 0), tip + Vector3(0, 0, size)},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// Two cones on a common polygon: two points with `around` triangles each.
inline IndexedMesh DoubleCone(int around)
{
  IndexedMesh mesh;
  for (int i = 0; i < around; ++i)
  {
    const double a = 2.0 * M_PI * i / around;
    mesh.Points.emplace_back(std::cos(a), std::sin(a), 0.0);
    mesh.Triangles.push_back({i, (i + 1) % around, around});
    mesh.Triangles.push_back({(i + 1) % around, i, around + 1});
  }
  mesh.Points.emplace_back(0, 0, 1);
  mesh.Points.emplace_back(0, 0, -1);
  return mesh;
}

/// A strip with half a turn.
inline IndexedMesh MoebiusStrip(int around)
{
  IndexedMesh mesh;
  for (int i = 0; i < around; ++i)
  {
    const double a = 2.0 * M_PI * i / around;
    const Vector3 out(std::cos(a), std::sin(a), 0.0);
    const Vector3 across = std::cos(0.5 * a) * out + std::sin(0.5 * a) * Vector3::UnitZ();
    mesh.Points.push_back(3.0 * out - across);
    mesh.Points.push_back(3.0 * out + across);
    const bool isLast = i + 1 == around;
    const int c = isLast ? 1 : 2 * i + 2;
    const int d = isLast ? 0 : 2 * i + 3;
    mesh.Triangles.push_back({2 * i, c, d});
    mesh.Triangles.push_back({2 * i, d, 2 * i + 1});
  }
  return mesh;
}

/// Both meshes as parts of one.
inline IndexedMesh Join(IndexedMesh one, const IndexedMesh& other)
{
  const int offset = static_cast<int>(one.Points.size());
  one.Points.insert(one.Points.end(), other.Points.begin(), other.Points.end());
  for (const auto& t : other.Triangles)
  {
    one.Triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return one;
}

inline IndexedMesh Reversed(IndexedMesh mesh)
{
  for (auto& t : mesh.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

/// Every triangle with points of its own, as in STL files.
inline IndexedMesh Unwelded(const IndexedMesh& mesh)
{
  IndexedMesh apart;
  for (const auto& t : mesh.Triangles)
  {
    const int first = static_cast<int>(apart.Points.size());
    for (const int corner : t)
    {
      apart.Points.push_back(mesh.Points[corner]);
    }
    apart.Triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

/// A smooth body without symmetry, of genus 0: a sphere with lobes.
inline IndexedMesh Lobed(int frequency)
{
  IndexedMesh mesh = Sphere(frequency);
  for (Vector3& p : mesh.Points)
  {
    p *= 20.0 + 4.0 * std::sin(3.0 * p[0] + 1.0) * std::cos(4.0 * p[1]) + 3.0 * p[2] * p[0];
  }
  return mesh;
}
} // namespace palpate::test
