#pragma once

#include "IndexedMesh.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// Samples of a closed surface for a fit of a surface model: one entry of each array per point.
struct SurfaceSamples
{
  std::vector<Vector3> Points;     ///< mm
  std::vector<Vector3> Normals;    ///< unit vectors, outward
  std::vector<double> Weights;     ///< surface area that the point stands for; they sum to 1
  std::vector<Vector3> Parameters; ///< unit vectors: places on the parameter sphere
  std::vector<int> Triangles;      ///< of the samples that are not vertices
};

/// A third of the shortest wavelength of a degree on the parameter sphere (rad): samples that are
/// farther apart leave a surface of that degree undetermined between them.
double SampleSpacingFor(int degree) noexcept;

/// Samples a closed mesh whose vertices have parameters (one unit vector each): first its vertices,
/// then points inside of triangles that an edge longer than `longestEdge` (rad) bounds on the
/// parameter sphere, so that no part of the sphere is without samples. Such a triangle is divided
/// into up to 64 equal ones, whose centres get its area; the area of the others goes to their
/// corners. Normals are area-weighted.
SurfaceSamples SampleMesh(const IndexedMesh& mesh, const std::vector<Vector3>& parameters,
                          double longestEdge);
} // namespace palpate
