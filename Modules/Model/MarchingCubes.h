#pragma once

#include "IndexedMesh.h"

#include <array>
#include <functional>

namespace palpate
{
/// Samples of a regular grid, read row by row, each row once.
struct SampledGrid
{
  std::array<int, 3> Size{};                         ///< samples along i, j, k
  std::function<void(int j, int k, float* row)> Row; ///< writes the samples along i
  /// Of every sample beyond the grid, so that the surface is closed. Not above the level.
  float Beyond = 0.0F;
};

/// The surface between samples above `level` and the others, in steps of the grid from its first
/// sample: closed, oriented from above to below, a two-manifold, with all of its pieces. A vertex
/// on each edge between neighbours that it parts, by linear interpolation but not closer than a
/// thousandth of the edge to its ends; samples above that share only an edge or a corner are apart.
/// Holds two slices of samples. False if there would be more than a thousand million points.
///
/// Marching cubes (Lorensen and Cline, SIGGRAPH 1987), with faces that fit each other.
bool MarchCubes(const SampledGrid& grid, float level, IndexedMesh& mesh);
} // namespace palpate
