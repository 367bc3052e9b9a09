#pragma once

#include "SphericalHarmonicModel.h"
#include "Vector3.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
/// f(u) = |x(u) - q|^2 / 2 (mm^2) as a function of the direction u, to second order at one
/// direction: what a search for the nearest point minimises on the unit sphere. Points are relative
/// to the model's centre. With a = u.(q - x) and d the rest of q - x, which is tangent to the
/// sphere,
///   grad f = -a g - R d,
///   Hess f = R^2 I + g g' - a H - g d' - d g' + R a I,
/// the first two terms being the surface's metric. In the plane a matrix A has the adjugate
/// tr(A) I - A, so no basis of the tangent plane is needed.
struct SquaredDistance
{
  SquaredDistance(const Vector3& direction, const SphericalHarmonicModel::SecondOrderSample& sample,
                  const Vector3& query) noexcept
      : Offset(query - sample.Radius * direction)
  {
    // Sums are grouped so that few operations wait for others: a servo tick is one chain of them.
    const double radius = sample.Radius;
    const Vector3& u = direction;
    const Vector3& g = sample.SurfaceGradient;
    const Matrix3& h = sample.SurfaceHessian;
    const double along = query.dot(u) - radius * u.squaredNorm();
    const Vector3 across = this->Offset - along * u;
    this->Gradient = -along * g - radius * across;
    const double round = radius * (radius + along);
    // g g' - g d' - d g' = (g - d) (g - d)' - d d'
    const Vector3 sum = g - across;
    const auto entry = [&](int i, int j, double unit)
    {
      return (sum[i] * sum[j] - across[i] * across[j]) -
             (along * h(i, j) - round * (unit - u[i] * u[j]));
    };
    this->Xx = entry(0, 0, 1.0);
    this->Yy = entry(1, 1, 1.0);
    this->Zz = entry(2, 2, 1.0);
    this->Xy = entry(0, 1, 0.0);
    this->Xz = entry(0, 2, 0.0);
    this->Yz = entry(1, 2, 0.0);
    this->Trace = this->Xx + this->Yy + this->Zz;
    // One eigenvalue is zero, so the sum of the principal minors is the product of the others.
    this->Determinant = (this->Xx * this->Yy - this->Xy * this->Xy) +
                        (this->Xx * this->Zz - this->Xz * this->Xz) +
                        (this->Yy * this->Zz - this->Yz * this->Yz);
  }

  /// Whether the Hessian is positive definite in the tangent plane.
  bool IsConvex() const noexcept { return this->Trace > 0.0 && this->Determinant > 0.0; }
  /// In the tangent plane, mm^2/rad^2.
  double SmallestEigenvalue() const noexcept
  {
    // The larger root in magnitude first: the other then keeps its digits.
    const double half = 0.5 * this->Trace;
    const double spread = std::sqrt(std::max(0.0, half * half - this->Determinant));
    return half > 0.0 ? this->Determinant / (half + spread) : half - spread;
  }

  /// Newton's step (rad, tangent to the sphere) of the function with `shift` times the identity
  /// added to its Hessian; that must leave it positive definite.
  Vector3 Step(double shift) const noexcept
  {
    const Vector3& g = this->Gradient;
    const Vector3 image(this->Xx * g[0] + this->Xy * g[1] + this->Xz * g[2],
                        this->Xy * g[0] + this->Yy * g[1] + this->Yz * g[2],
                        this->Xz * g[0] + this->Yz * g[1] + this->Zz * g[2]);
    const double scale = 1.0 / (this->Determinant + shift * (this->Trace + shift));
    return scale * (image - (this->Trace + shift) * g);
  }

  Vector3 Offset;   ///< query - point, mm
  Vector3 Gradient; ///< mm^2/rad, tangent to the sphere
  double Trace;     ///< of the Hessian in the tangent plane, mm^2/rad^2
  double Determinant;

private:
  double Xx, Yy, Zz, Xy, Xz, Yz; // the Hessian; zero along the direction
};
} // namespace palpate
