#pragma once

#include "StarMesh.h"
#include "Vector3.h"

#include <array>
#include <vector>

namespace palpate
{
/// Trilinear shape functions of a hexahedron at its 2 x 2 x 2 Gauss points (Hughes, The Finite
/// Element Method, 1987, chapter 3).
class HexahedronShape
{
public:
  struct Point
  {
    Vector3 Position;                 ///< mm
    double Volume;                    ///< weight times Jacobian, mm^3
    std::array<double, 8> Shape;      ///< of the nodes
    std::array<Vector3, 8> Gradients; ///< of the shape functions, 1/mm
  };

  HexahedronShape(const std::vector<Vector3>& nodes, const StarMesh::Element& element) noexcept;

  const std::array<Point, 8>& Points() const noexcept { return this->GaussPoints; }
  /// Whether the element keeps its orientation at all Gauss points.
  bool IsValid() const noexcept;

private:
  std::array<Point, 8> GaussPoints;
};
} // namespace palpate
