#pragma once

#include "FieldGrid.h"
#include "RayCaster.h"

#include <random>

namespace palpate::test
{
/// Rays in index coordinates, with difficult ones: through nodes, along edges and faces, through
/// corners diagonally, axis-parallel. They start outside or inside the grid.
inline FieldRay RandomRay(const FieldGrid& grid, std::mt19937_64& random)
{
  std::normal_distribution<double> normal;
  FieldRay ray;
  const bool isOnNodes = random() % 2 == 0;
  const bool isStepped = random() % 2 == 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int nodes = grid.Size()[static_cast<std::size_t>(axis)];
    const double half = static_cast<double>(random() % static_cast<unsigned>(2 * nodes - 1)) / 2.0;
    ray.Origin[axis] =
        isOnNodes ? half : std::uniform_real_distribution<double>(0, nodes - 1)(random);
    ray.Direction[axis] = isStepped ? static_cast<double>(random() % 3) - 1.0 : normal(random);
  }
  if (ray.Direction.isZero())
  {
    ray.Direction[static_cast<int>(random() % 3)] = random() % 2 == 0 ? 1.0 : -1.0;
  }
  if (random() % 2 == 0)
  {
    ray.Origin -= 64.0 * ray.Direction; // exact for those on nodes
  }
  return ray;
}
} // namespace palpate::test
