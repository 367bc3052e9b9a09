#pragma once

#include "MappedVertex.h"
#include "VertexRings.h"

#include <array>
#include <cstddef>
#include <deque>
#include <vector>

namespace palpate
{
/// Moves all directions of a map to the sphere at once. Single vertices settle details, but where
/// large parts have to move together, each of their steps is small. L-BFGS (Nocedal 1980),
/// preconditioned by the curvature along each vertex. Every triangle keeps D > 0. Time and memory
/// are linear in the vertices.
///
/// The energy is that of VertexRelaxation with less weight on area, sqrt(A / D) N / D: bent horns
/// that are to keep their areas may lie to one side on the sphere or to the other, with almost the
/// same energy, while a conformal map (no weight) is unique.
class MapDescent
{
public:
  /// `present` are the vertices that `rings` has, mapped one to one; the last two are kept.
  MapDescent(const VertexRings& rings, const std::vector<int>& present,
             std::vector<MappedVertex>& vertices);

  /// Of a surface that is mapped without distortion, 2^2.5 times its area.
  double Energy() const noexcept { return this->Current; }
  /// Ends early once ten steps hardly lower the energy.
  void Run(int mostSteps);

private:
  struct Triangle
  {
    std::array<int, 3> Corners;    // in Present
    std::array<double, 3> Weights; // in N, of the edge opposite to each corner, times 2 sqrt(A)
  };
  using Field = std::vector<Vector3>; // one vector per vertex

  // A step and the gradient's change with it.
  struct Pair
  {
    Field Step;
    Field Change;
    double Scale; // 1 / Step . Change
  };

  void AddTriangles(const VertexRings& rings);
  void AddTriangle(int a, int b, int c);
  double EnergyOf(const Field& directions) const;
  void FindGradient();
  void AddGradient(const Triangle& triangle);
  Field Direction() const;
  double LargestScale(const Field& direction) const;
  bool Advance(const Field& direction, Field& moved, double& energy) const;
  void Remember(const Field& before, const Field& gradient);

  const std::vector<int>& Present;
  std::vector<MappedVertex>& Vertices;
  std::vector<Triangle> Triangles;
  Field Directions;
  Field Gradient;
  std::vector<double> Curvature; // of the energy along each vertex's steps, about
  std::deque<Pair> Memory;
  double Current = 0.0;
};
} // namespace palpate
