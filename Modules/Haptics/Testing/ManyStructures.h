#pragma once

#include "MeshCases.h"
#include "TouchScene.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace palpate::test
{
/// A cube of facets.
inline std::shared_ptr<const ContactModel> BlockContact(const Vector3& centerWorld, double halfSize)
{
  Mesh mesh = BoxMesh(Vector3::Constant(halfSize));
  for (Vector3& point : mesh.Points)
  {
    point += centerWorld;
  }
  return FacetContact(mesh);
}

/// Cubes of 4 mm on a lattice of 10 mm round the origin, nearest first, to be felt by a ball of 2
/// mm.
inline TouchScene ManyStructures(int count)
{
  constexpr double Apart = 10.0; // mm
  const int half = static_cast<int>(std::ceil(0.5 * std::cbrt(count)));
  std::vector<Vector3> places;
  for (int x = -half; x <= half; ++x)
  {
    for (int y = -half; y <= half; ++y)
    {
      for (int z = -half; z <= half; ++z)
      {
        places.push_back(Apart * Vector3(x, y, z));
      }
    }
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Vector3& a, const Vector3& b)
                   { return a.squaredNorm() < b.squaredNorm(); });
  TouchScene scene;
  scene.Tool = ToolShape::Sphere(2.0);
  for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n)
  {
    scene.Structures.push_back(
        {"block " + std::to_string(n), BlockContact(places[n], 2.0), {0.5, 0.001}, {}});
  }
  return scene;
}

/// A hand that strokes over the first of them at 50 mm/s, 1 mm deep, at 1 kHz.
inline Vector3 PlaceOnFirst(int tick)
{
  return {std::sin(0.05 * tick), 0.3 * std::cos(0.031 * tick), 3.0};
}
} // namespace palpate::test
