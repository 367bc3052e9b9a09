#pragma once

#include "BrickLayout.h"
#include "FieldMaterial.h"
#include "Vector3.h"

#include <array>
#include <vector>

namespace palpate::test
{
/// Brute-force reference: all samples in one array, interpolated in long double by the textbook
/// formulas. The cubic B-spline's coefficients come from its linear equations, line by line.
class DenseReference
{
public:
  using Real = long double;
  using Point = std::array<Real, 3>;

  DenseReference(const std::array<int, 3>& size, const std::vector<double>& samples,
                 FieldInterpolation interpolation);

  Real Value(const Point& pointIndex) const;
  Point Gradient(const Point& pointIndex) const;

private:
  struct Weights
  {
    int First = 0;
    int Count = 0;
    Real Value[4] = {};
    Real Slope[4] = {};
  };
  Weights WeightsAt(Real position, int nodes) const;
  Real Sum(const std::array<Weights, 3>& weights, int slopeAxis) const;
  Real Node(int i, int j, int k) const;
  void SolveLine(std::size_t first, std::size_t stride, int length);

  std::array<int, 3> Size;
  FieldInterpolation Interpolation;
  std::vector<Real> Nodes;
};

inline DenseReference::Point ToPoint(const Vector3& p)
{
  return {p[0], p[1], p[2]};
}
} // namespace palpate::test
