#pragma once

#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "RadialSamples.h"
#include "StarShape.h"
#include "Vector3.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Rays from a centre to a closed surface; each entry of a list is one ray's.
struct RadialSampling
{
  Vector3 CenterWorld = Vector3::Zero(); ///< mm
  StarShapeVerdict Seen;                 ///< from the centre
  double MultiplePercent = 0.0;          ///< of the sphere of directions: more than one crossing
  double MissedPercent = 0.0;            ///< of the sphere of directions: no crossing

  std::vector<Vector3> Directions; ///< unit vectors
  std::vector<double> SolidAngles; ///< sr
  std::vector<int> Crossings;      ///< with the surface
  std::vector<double> Radii;       ///< mm; 0 without a crossing
  /// mm^2: area of the surface that the crossing stands for, solid angle * distance^2 * cosine of
  /// the incidence, so that a squared radial error is the squared distance along the normal,
  /// integrated over the surface. The cosine counts as 0.05 or more, since a sample on a surface
  /// seen edge-on still locates the surface.
  std::vector<double> AreaWeights;

  std::size_t Bytes() const
  {
    return this->Directions.size() * (sizeof(Vector3) + 3 * sizeof(double) + sizeof(int));
  }
};

enum class RadialWeight
{
  Area,       ///< small distances along the normal
  SolidAngle, ///< small radial distances
  Uniform
};

/// Which of several crossings gives the radius: the outermost keeps the silhouette, the innermost
/// the part that the centre sees.
enum class RadialCrossing
{
  Outermost,
  Innermost
};

/// Judges the surface from the centre and measures its distance along directions with their solid
/// angles (sr). Incomplete where `progress` cancels.
RadialSampling SampleRadially(const IndexedMesh& mesh, const Vector3& centerWorld,
                              std::vector<Vector3> directions, std::vector<double> solidAngles,
                              RadialCrossing crossing, const KernelProgress& progress);

/// The same along the directions of an icosahedron, to the outermost crossings.
RadialSampling SampleRadially(const IndexedMesh& mesh, const Vector3& centerWorld, int frequency,
                              const KernelProgress& progress);

/// The rays that cross the surface, as the input of a fit.
RadialSamples SamplesOf(const RadialSampling& sampling, RadialWeight weight);
} // namespace palpate
