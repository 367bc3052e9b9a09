#pragma once

#include "IndexedMesh.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// Samples of a closed surface for a parametric fit: one entry of each array per point.
struct SurfaceSamples
{
  std::vector<Vector3> Points;     ///< mm
  std::vector<Vector3> Normals;    ///< unit vectors, outward
  std::vector<double> Weights;     ///< surface area that the point stands for; they sum to 1
  std::vector<Vector3> Parameters; ///< unit vectors: places on the parameter sphere
};

/// The vertices of a closed mesh with their share of its area, their area-weighted normals, and
/// their parameters (one unit vector per vertex).
SurfaceSamples SampleVertices(const IndexedMesh& mesh, std::vector<Vector3> parameters);
} // namespace palpate
