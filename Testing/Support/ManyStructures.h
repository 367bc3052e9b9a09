#pragma once

#include "FacetContactModel.h"
#include "IcosahedronDirections.h"
#include "TouchScene.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace palpate::test
{
/// A sphere of 20 facets; null if it cannot be made.
inline std::shared_ptr<const ContactModel> FacetSphere(const Vector3& centerWorld, double radius)
{
  const IcosahedronDirections sphere(1);
  std::vector<Vector3> points;
  for (const Vector3& u : sphere.Directions())
  {
    points.push_back(centerWorld + radius * u);
  }
  std::shared_ptr<const ContactModel> model;
  return FacetContactModel::Make(points, sphere.Triangles(), model).IsOk() ? model : nullptr;
}

/// Spheres of 2 mm on a lattice around the origin with this spacing (mm), nearest first, to be
/// touched by a sphere of 2 mm.
inline TouchScene ManyStructures(int count, double apart = 10.0)
{
  const int half = static_cast<int>(std::ceil(0.5 * std::cbrt(count)));
  std::vector<Vector3> places;
  for (int x = -half; x <= half; ++x)
  {
    for (int y = -half; y <= half; ++y)
    {
      for (int z = -half; z <= half; ++z)
      {
        places.push_back(apart * Vector3(x, y, z));
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
        {"ball " + std::to_string(n), FacetSphere(places[n], 2.0), {0.5, 0.001}, {}});
  }
  return scene;
}

/// A hand that strokes over the first of them at 50 mm/s, at least half a millimetre deep, at 1
/// kHz.
inline Vector3 PlaceOnFirst(int tick)
{
  return {0.7 * std::sin(0.05 * tick), 0.3 * std::cos(0.031 * tick), 3.0};
}
} // namespace palpate::test
