#pragma once

#include "IcosahedronDirections.h"
#include "IndexedMesh.h"
#include "RandomShapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace palpate::test
{
/// The icosahedron's triangulation with `frequency`, each direction moved by `place`.
inline IndexedMesh ClosedMesh(int frequency, const std::function<Vector3(const Vector3&)>& place)
{
  const IcosahedronDirections sphere(frequency);
  IndexedMesh mesh;
  for (const Vector3& u : sphere.Directions())
  {
    mesh.Points.push_back(place(u));
  }
  mesh.Triangles.assign(sphere.Triangles().begin(), sphere.Triangles().end());
  return mesh;
}

inline IndexedMesh SphereMesh(int frequency)
{
  return ClosedMesh(frequency, [](const Vector3& u) { return u; });
}

/// Star-shaped with log-radius of degree 6, mm.
inline IndexedMesh RandomStarMesh(Random& random, int frequency)
{
  const std::vector<double> coefficients = RandomCoefficients(random, 6, 1.0);
  const SphericalHarmonicBasis basis(6);
  std::vector<double> values(basis.Size());
  return ClosedMesh(frequency,
                    [&](const Vector3& u)
                    {
                      basis.Evaluate(u, values.data());
                      return Vector3(u * 20.0 *
                                     std::exp(std::inner_product(values.begin(), values.end(),
                                                                 coefficients.begin(), 0.0)));
                    });
}

/// A sausage of half-length `length` and radius 1 along an arc of `angle` rad. Not star-shaped.
inline IndexedMesh BentMesh(int frequency, double length, double angle)
{
  const double radius = 2.0 * length / angle;
  return ClosedMesh(frequency,
                    [=](const Vector3& u)
                    {
                      const double phi = 0.5 * angle * u.z();
                      const double across = radius + u.x();
                      return Vector3(across * std::cos(phi), u.y(), across * std::sin(phi));
                    });
}

/// A sphere with six spikes of some `height` radii.
inline IndexedMesh SpikedMesh(int frequency, double height)
{
  return ClosedMesh(frequency,
                    [=](const Vector3& u)
                    {
                      const double off = 1.0 - u.cwiseAbs().maxCoeff();
                      return Vector3(u * (1.0 + height * std::exp(-off / 0.01)));
                    });
}

/// `count` points on the equator, joined with both poles.
inline IndexedMesh Bipyramid(int count)
{
  IndexedMesh mesh;
  mesh.Points = {Vector3::UnitZ(), -Vector3::UnitZ()};
  for (int i = 0; i < count; ++i)
  {
    const double phi = 2.0 * M_PI * i / count;
    mesh.Points.emplace_back(std::cos(phi), std::sin(phi), 0.0);
    const int next = 2 + (i + 1) % count;
    mesh.Triangles.push_back({0, 2 + i, next});
    mesh.Triangles.push_back({1, next, 2 + i});
  }
  return mesh;
}

inline IndexedMesh TetrahedronMesh()
{
  IndexedMesh mesh;
  mesh.Points = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  mesh.Triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

inline IndexedMesh TorusMesh(int around, int across)
{
  IndexedMesh mesh;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double phi = 2.0 * M_PI * i / around;
      const double theta = 2.0 * M_PI * j / across;
      const double r = 3.0 + std::cos(theta);
      mesh.Points.emplace_back(r * std::cos(phi), r * std::sin(phi), std::sin(theta));
      const auto at = [&](int k, int l) { return k % around * across + l % across; };
      mesh.Triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.Triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// Both meshes in one list, the second one apart.
inline IndexedMesh Union(IndexedMesh a, const IndexedMesh& b)
{
  const int offset = static_cast<int>(a.Points.size());
  for (const Vector3& point : b.Points)
  {
    a.Points.emplace_back(point + Vector3(100.0, 0.0, 0.0));
  }
  for (const std::array<int, 3>& t : b.Triangles)
  {
    a.Triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return a;
}

inline IndexedMesh Moved(IndexedMesh mesh, const Matrix3& matrix, const Vector3& shift)
{
  for (Vector3& point : mesh.Points)
  {
    point = matrix * point + shift;
  }
  return mesh;
}

inline IndexedMesh MirroredMesh(IndexedMesh mesh)
{
  for (Vector3& point : mesh.Points)
  {
    point.x() = -point.x();
  }
  for (std::array<int, 3>& t : mesh.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

/// Points and triangles in another, random order.
inline IndexedMesh Renumbered(const IndexedMesh& mesh, Random& random)
{
  std::vector<int> number(mesh.Points.size());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  IndexedMesh result = mesh;
  for (std::size_t i = 0; i < number.size(); ++i)
  {
    result.Points[static_cast<std::size_t>(number[i])] = mesh.Points[i];
  }
  for (std::array<int, 3>& t : result.Triangles)
  {
    t = {number[static_cast<std::size_t>(t[1])], number[static_cast<std::size_t>(t[2])],
         number[static_cast<std::size_t>(t[0])]};
  }
  std::shuffle(result.Triangles.begin(), result.Triangles.end(), random);
  return result;
}
} // namespace palpate::test
