#pragma once

#include "ParametricSphericalSurface.h"
#include "SphericalTriangle.h"

namespace palpate
{
/// Bounds of a parametric surface's derivatives along great circles of the parameter sphere, by the
/// arc's angle: over the whole sphere, and around a sample. They include the error of evaluation
/// and hold up to rounding, which is added as a relative 1e-9.
///
/// Carry two tangents s, t along a great circle, parallel. Then e . X_st, for a fixed direction e
/// of space, is a trigonometric polynomial of degree L of the arc. If its largest size is M, an
/// angle r away from a value g it is at most M cos(max(0, acos(g / M) - L r)), and its derivative
/// is at most L M (M. Riesz 1914, Bernstein 1912). So second derivatives at parameters that leave
/// gaps of the angle r bound those everywhere by their maximum over cos(L r), and those in a cap by
/// the value at its centre. The third derivative is also bounded degree by degree, from the
/// coefficients, which is narrower where high degrees are weak. Evaluates the surface in about 40
/// L^2 parameters.
class ParametricSurfaceBounds
{
public:
  explicit ParametricSurfaceBounds(const ParametricSphericalSurface& surface);

  /// |X_t| (mm/rad), |X_tt| (mm/rad^2) and the change of X_tt along any arc (mm/rad^3), everywhere.
  double First() const noexcept { return this->LargestFirst; }
  double Second() const noexcept { return this->LargestSecond; }
  double Third() const noexcept { return this->LargestThird; }

  /// |X_t| and |X_tt| at every parameter within `angle` (rad) of that of the sample; the whole
  /// sphere's if the angle is not a number. Allocation-free.
  double FirstAround(const ParametricSphericalSurface::SecondOrderSample& sample,
                     double angle) const noexcept;
  double SecondAround(const ParametricSphericalSurface::SecondOrderSample& sample,
                      double angle) const noexcept;

  /// |X_tt| at every parameter in the triangle, by SecondAround the centres of its 4^refinement
  /// parts. Allocation-free.
  double SecondOver(const ParametricSphericalSurface& surface, const SphericalTriangle& triangle,
                    int refinement = 0) const noexcept;

  /// Largest |X_tt| at one parameter, over all unit tangents t: an upper bound, at most 1.4 times
  /// the largest and usually some per cent above it.
  static double
  LargestSecondAt(const ParametricSphericalSurface::SecondOrderSample& sample) noexcept;
  /// Largest |X_t| at one parameter, exact.
  static double LargestFirstAt(const std::array<Vector3, 2>& first) noexcept;

  /// Bounds (mm) the distance of every X(u), u in the triangle, from the flat triangle of the
  /// points at its corners, if |X_tt| <= `second` in the triangle: up to 0.20 `second` edge^2. (1/8
  /// of it holds along an edge, but not inside.) Edges are at most a quarter of a circle.
  static double DeviationFromTriangle(const SphericalTriangle& triangle, double second) noexcept;

private:
  int Degree;
  double LargestFirst = 0.0;
  double LargestSecond = 0.0;
  double LargestThird = 0.0;
  double FirstError = 0.0;
  double SecondError = 0.0;
};
} // namespace palpate
