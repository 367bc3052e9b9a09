#pragma once

#include "RadialModel.h"
#include "Status.h"
#include "Vector3.h"

#include <array>
#include <vector>

namespace palpate
{
/// Hexahedra that fill a radial model: a rounded cube of n x n x n in the middle and n/2
/// layers on each of its six sides, n elements along a quarter of a great circle. A point of the
/// unit ball with direction d is moved along d only, to p (R0 + (R(d) - R0) |p|), which is one to
/// one where R(d) > R0/2. Positions are relative to the model's centre, in its axes (patient LPS).
class StarMesh
{
public:
  /// In the order of VTK_HEXAHEDRON.
  using Element = std::array<int, 8>;
  /// Of a node: three coordinates in the cube's lattice, 0 to n, and the layer, 0 in the cube.
  /// Those of an element's nodes differ by at most one in each. A node of a layer has the lattice
  /// coordinates of the node on the cube's surface below it.
  using Place = std::array<int, 4>;
  /// A side of an element on the surface, counterclockwise from outside.
  struct Face
  {
    std::array<int, 4> Nodes;
    /// Of the corners, on the cube [-1, 1]^3.
    std::array<Vector3, 4> OnCube;
  };
  /// Directions inside a face, and their measure.
  struct FacePoint
  {
    Vector3 Direction;
    double SolidAngle; ///< per unit of (s, t), sr
    std::array<double, 4> Shape;
  };

  static constexpr int FewestElements = 2;
  static constexpr int MostElements = 40;

  /// `elementsAcross` is n: even, from FewestElements to MostElements. Fails for a model whose
  /// radius is not positive everywhere, or so rough that elements overlap. Allocates.
  static Status Make(const RadialModel& model, int elementsAcross, StarMesh& mesh);

  const std::vector<Vector3>& Nodes() const noexcept { return this->NodePoints; }
  /// Of each node.
  const std::vector<Place>& Places() const noexcept { return this->NodePlaces; }
  const std::vector<Element>& Elements() const noexcept { return this->Hexahedra; }
  const std::vector<Face>& Faces() const noexcept { return this->SurfaceFaces; }
  /// Mean edge of the elements at the surface, mm.
  double SurfaceEdge() const noexcept;

  /// At (s, t) in [-1, 1]^2 of a face: bilinear on the cube, with equal angles along its edges.
  static FacePoint At(const Face& face, double s, double t) noexcept;

private:
  std::vector<Vector3> NodePoints; // mm
  std::vector<Place> NodePlaces;
  std::vector<Element> Hexahedra;
  std::vector<Face> SurfaceFaces;
};
} // namespace palpate
