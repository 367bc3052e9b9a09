#pragma once

#include "OrganModel.h"
#include "Vector3.h"

#include <Eigen/Core>

#include <array>
#include <utility>
#include <vector>

namespace palpate
{
/// A shape as points, and how far each moves along the outward normal (mm) when coefficients
/// change: to first order a linear map, so that statistics of coefficients and of points are one.
struct NormalDisplacement
{
  std::vector<Vector3> Points;  ///< mm, in the shape's frame
  std::vector<Vector3> Normals; ///< unit, outward
  std::vector<double> Areas;    ///< of each point: a third of its triangles, mm^2
  std::vector<std::array<int, 3>> Triangles;
  std::vector<std::pair<int, int>> Edges; ///< of the triangles, each once
  /// Points x coefficients (mm per mm): of a radial model the harmonic times the cosine between
  /// direction and normal, of a surface model the harmonics times the normal's x, y and z.
  Eigen::MatrixXd PerCoefficient;
};

/// At the directions of an icosahedron of this frequency (IcosahedronDirections). Allocates.
NormalDisplacement FindNormalDisplacement(const OrganModel& shape, int frequency);
} // namespace palpate
