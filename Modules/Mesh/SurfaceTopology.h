#pragma once

#include "IndexedMesh.h"
#include "Status.h"

#include <string>

namespace palpate
{
/// What a triangle mesh is. Edges, holes, parts and so on are those of the triangles with three
/// different valid indices; the others are counted and left out. An edge joins two points by index:
/// points at equal positions are different until they are welded (MeshMending).
struct SurfaceTopology
{
  int Points = 0;
  int Triangles = 0;
  int NonFinitePoints = 0;
  int UnusedPoints = 0;
  int InvalidTriangles = 0;    ///< with indices out of range
  int DegenerateTriangles = 0; ///< with a point twice
  int FlatTriangles = 0;       ///< with three points but no area, up to rounding
  int DuplicateTriangles = 0;  ///< beyond the first with the same three points, in any order
  int Edges = 0;
  int BoundaryEdges = 0;        ///< of one triangle
  int Holes = 0;                ///< connected sets of boundary edges
  int NonManifoldEdges = 0;     ///< of more than two triangles
  int PinchedPoints = 0;        ///< whose triangles form more than one fan
  int OrientationConflicts = 0; ///< edges that two triangles run along in the same direction
  bool IsOrientable = true;     ///< no part is one-sided as a Moebius strip
  int Parts = 0;                ///< connected across edges
  int EulerCharacteristic = 0;  ///< points - edges + triangles, a pinched point once per fan
  double Area = 0.0;            ///< mm^2; 0 if points are not finite
  double Volume = 0.0;          ///< mm^3, signed; of a closed surface, negative if inside out

  /// Two triangles at every edge, which run along it in opposite directions: then winding numbers
  /// do not depend on the direction in which they are counted.
  bool IsConsistent() const noexcept
  {
    return this->BoundaryEdges == 0 && this->NonManifoldEdges == 0 &&
           this->OrientationConflicts == 0;
  }
  /// Of a closed, orientable manifold: the handles of all parts together.
  int Handles() const noexcept { return this->Parts - this->EulerCharacteristic / 2; }
};

struct EnclosedMeasure
{
  double Volume = 0.0; ///< mm^3, signed
  double Area = 0.0;   ///< mm^2
};

/// Volume and area alone, of all triangles of a mesh with valid indices.
EnclosedMeasure MeasureEnclosed(const IndexedMesh& mesh);

/// Linear time; 5 million triangles take some 2 s and 130 MB in addition to the mesh. Any input is
/// allowed, up to 700 million triangles; beyond, only Points and Triangles are set.
SurfaceTopology DescribeTopology(const IndexedMesh& mesh);

/// Why the mesh is not one closed surface without handles, oriented outwards, all of whose points
/// are used, as a predicate ("has 1 hole"): the first such fact. Empty if it is one.
std::string FaultOfGenusZero(const SurfaceTopology& topology);

/// Whether the mesh is one closed surface without handles, oriented outwards, all of whose points
/// are used. The failure names the first fact that prevents it.
Status CheckClosedGenusZero(const SurfaceTopology& topology);
} // namespace palpate
