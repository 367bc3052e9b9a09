#pragma once

#include "OrderSums.h"

// The rule of Quartet.h applies here too.

namespace palpate::evaluation
{
/// Spatial derivatives of an extension of R whose w^m are harmonic in the plane: d2/dy2 is minus
/// d2/dx2.
template <typename Set, typename Number>
struct SpaceDerivatives
{
  Number X;
  Number Y;
  Number Z;
  Number XX;
  Number XY;
  Number XZ;
  Number YZ;
  Number ZZ;
};

/// Gradient of R on the unit sphere and the lower triangle of its Hessian.
template <typename Set, typename Number>
struct SurfaceDerivatives
{
  Number X;
  Number Y;
  Number Z;
  Number XX;
  Number XY;
  Number XZ;
  Number YY;
  Number YZ;
  Number ZZ;
};

/// The tangential part of the gradient and the surface Hessian, T H T - (g . u) T with
/// T = I - u u^T. With q = H u - (u . H u + g . u) / 2 u the latter is H - u q^T - q u^T - (g . u)
/// I.
template <typename Set, typename Number>
PALPATE_INLINE SurfaceDerivatives<Set, Number>
ToSurface(const SpaceDerivatives<Set, Number>& d, const Number& x, const Number& y, const Number& z)
{
  const Number radial = d.X * x + d.Y * y + d.Z * z;
  const Number hx = d.XX * x + d.XY * y + d.XZ * z;
  const Number hy = d.XY * x - d.XX * y + d.YZ * z;
  const Number hz = d.XZ * x + d.YZ * y + d.ZZ * z;
  const Number half = typename Set::Real(0.5) * (x * hx + y * hy + z * hz + radial);
  const Number qx = hx - half * x;
  const Number qy = hy - half * y;
  const Number qz = hz - half * z;
  return {d.X - radial * x,
          d.Y - radial * y,
          d.Z - radial * z,
          d.XX - radial - (x + x) * qx,
          d.XY - x * qy - y * qx,
          d.XZ - x * qz - z * qx,
          -d.XX - radial - (y + y) * qy,
          d.YZ - y * qz - z * qy,
          d.ZZ - radial - (z + z) * qz};
}

/// Writes 13 numbers: R, the gradient and all nine entries of the Hessian.
template <typename Set>
PALPATE_INLINE void WriteSecondOrder(typename Set::Real value,
                                     const SurfaceDerivatives<Set, typename Set::Real>& d,
                                     typename Set::Real* sample)
{
  sample[0] = value;
  sample[1] = d.X;
  sample[2] = d.Y;
  sample[3] = d.Z;
  sample[4] = d.XX;
  sample[5] = d.XY;
  sample[6] = d.XZ;
  sample[7] = d.XY;
  sample[8] = d.YY;
  sample[9] = d.YZ;
  sample[10] = d.XZ;
  sample[11] = d.YZ;
  sample[12] = d.ZZ;
}

/// R and its spatial derivatives from the sums over the orders.
template <typename Set>
struct SpaceSample
{
  using Real = typename Set::Real;

  /// The second derivative in z is `curvatureScale` times the value in the blocks and the zonal
  /// terms.
  PALPATE_INLINE SpaceSample(const OrderSums<Set, 2>& sums, const LanePowers<Set>& powers,
                             const ZonalTerms<Set>& zonal, Real curvatureScale)
  {
    const ComplexQuartet<Set> plane = Turned(sums.First, powers.First);
    const ComplexQuartet<Set> planeSlope = Turned(sums.FirstSlope, powers.First);
    const ComplexQuartet<Set> second = Turned(sums.Second, powers.Second);
    const Quartet<Set> first =
        Sums(AddTerms(zonal.Value, sums.Value, powers.Value), plane.Real, plane.Imaginary,
             AddTerms(zonal.Slope, sums.Slope, powers.Value));
    const Quartet<Set> mixed =
        Sums(second.Real, second.Imaginary, planeSlope.Real, planeSlope.Imaginary);
    const auto curvature = AddTerms(zonal.Curvature, sums.Curvature, powers.Value).Sum();
    this->Value = first.Lane(0);
    this->Space = {first.Lane(1), first.Lane(2), first.Lane(3), mixed.Lane(0),
                   mixed.Lane(1), mixed.Lane(2), mixed.Lane(3), curvatureScale * curvature};
  }

  Real Value;
  SpaceDerivatives<Set, Real> Space;
};

/// Writes R, its gradient and its Hessian on the unit sphere.
template <typename Set>
PALPATE_INLINE void FinishHessian(const OrderSums<Set, 2>& sums, const LanePowers<Set>& powers,
                                  const ZonalTerms<Set>& zonal, const UnitVector<Set>& u,
                                  typename Set::Real curvatureScale, typename Set::Real* sample)
{
  using Real = typename Set::Real;
  const SpaceSample<Set> s(sums, powers, zonal, curvatureScale);
  WriteSecondOrder<Set>(
      s.Value, ToSurface<Set, Real>(s.Space, u.X.Lane(0), u.Y.Lane(0), u.Z.Lane(0)), sample);
}
} // namespace palpate::evaluation
