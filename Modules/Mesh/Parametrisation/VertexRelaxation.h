#pragma once

#include "MappedVertex.h"
#include "VertexRings.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Moves one direction of a map to the sphere at a time, against the energy of its triangles.
///
/// A triangle with corners q_i on the sphere, squared edge lengths l_i^2 and area A on the surface
/// has E = A^2 N / D^3, with D = det(q_1, q_2, q_3) and Dirichlet's numerator
///   N = sum over edges e of (sum of the two other l^2 - l_e^2) (1 - cos of e on the sphere).
/// E grows without bound as the spherical triangle degenerates, so a descent keeps D > 0. It is the
/// L2 stretch of Praun and Hoppe (2003) with more weight on area (A^2 / D^3 for A / D^2).
/// On the sphere N and D are linear in the moved corner, hence gradient and Hessian are short. Each
/// l^2 gets 0.5 % of the sum of the three added, which is the metric plus a share of an equilateral
/// one: needle triangles stay bounded.
class VertexRelaxation
{
public:
  static constexpr double EquilateralShare = 0.005;

  /// One damped Newton step for `vertex`; every triangle of its ring has D > 0 before and after.
  /// Returns by how much the step changed D, relative, at most; 0 if no step lowered the energy.
  double Step(std::vector<MappedVertex>& vertices, int vertex, Ring ring);

  /// True if every triangle of the ring has D > 0.
  bool IsInside(const std::vector<MappedVertex>& vertices, int vertex, Ring ring);

private:
  // A neighbour: its direction in the frame (E1, E2, moved direction) and its edge.
  struct Neighbour
  {
    double X, Y, Z;
    double U, V, W;
    double SquaredLength;
  };
  // In that frame D = m . q and N = Constant + g . q; g and Constant are multiplied by A^2.
  struct Triangle
  {
    double Mx, My, Mz;
    double Gx, Gy, Gz;
    double Constant;
  };

  void FindNeighbours(const std::vector<MappedVertex>& vertices, int vertex, Ring ring);
  void FindTriangles() noexcept;
  void FindDerivatives() noexcept;
  void FindNewtonStep() noexcept;
  double LimitStep() noexcept;
  double EnergyAt(double x, double y) const noexcept;

  std::vector<Neighbour> Neighbours; // the first is repeated at the end
  std::vector<Triangle> Triangles;
  std::size_t Count = 0;
  Vector3 E1, E2;
  double Energy = 0.0;
  double Gx = 0.0, Gy = 0.0;              // gradient
  double Hxx = 0.0, Hxy = 0.0, Hyy = 0.0; // Hessian on the sphere
  double Sx = 0.0, Sy = 0.0;              // step
};
} // namespace palpate
