#pragma once

#include "CenteredSurface.h"
#include "RadialModel.h"
#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
/// f(u) = |x(u) - q|^2 / 2 (mm^2) as a function of the direction u, to second order at one
/// direction: the objective of the closest-point search on the unit sphere. Points are relative to
/// the surface's centre. For a radial model, with a = u.(q - x) and d the rest of q - x,
/// which is tangent to the sphere,
///   grad f = -a g - R d,
///   Hess f = R^2 I + g g' - a H - g d' - d g' + R a I,
/// the first two terms being the surface's metric; for a surface model
///   f_a = -(q - x).x_a,   f_ab = x_a.x_b - (q - x).x_ab.
/// In the plane a matrix A has the adjugate
/// tr(A) I - A, so no basis of the tangent plane is needed.
struct SquaredDistance
{
  SquaredDistance() = default;
  SquaredDistance(const Vector3& direction, const RadialModel::SecondOrderSample& sample,
                  const Vector3& query) noexcept
  {
    // Sums are grouped to shorten the dependency chain of a servo tick.
    const auto [along, across] = this->Aim(direction, sample, query);
    const double radius = sample.Radius;
    const Vector3& u = direction;
    const Vector3& g = sample.SurfaceGradient;
    const Matrix3& h = sample.SurfaceHessian;
    const double round = radius * (radius + along);
    // g g' - g d' - d g' = (g - d) (g - d)' - d d'
    const Vector3 sum = g - across;
    // Pairs of entries, xx with yy and xz with yz, for two-lane vectors.
    using Pair = Eigen::Array2d;
    const Pair sumXy(sum[0], sum[1]);
    const Pair acrossXy(across[0], across[1]);
    const Pair directionXy(u[0], u[1]);
    const Pair squares = (sumXy * sumXy - acrossXy * acrossXy) -
                         (along * Pair(h(0, 0), h(1, 1)) - round * (1.0 - directionXy.square()));
    const Pair withZ = (sum[2] * sumXy - across[2] * acrossXy) -
                       (along * Pair(h(0, 2), h(1, 2)) + round * u[2] * directionXy);
    this->Xx = squares[0];
    this->Yy = squares[1];
    this->Xz = withZ[0];
    this->Yz = withZ[1];
    this->Zz =
        (sum[2] * sum[2] - across[2] * across[2]) - (along * h(2, 2) - round * (1.0 - u[2] * u[2]));
    this->Xy = (sum[0] * sum[1] - across[0] * across[1]) - (along * h(0, 1) + round * u[0] * u[1]);
    const double sumOfTwo = this->Xx + this->Yy;
    this->Trace = sumOfTwo + this->Zz;
    // One eigenvalue is zero, so the sum of the principal minors is the product of the others.
    this->Determinant = (this->Xx * this->Yy - this->Xy * this->Xy) +
                        (sumOfTwo * this->Zz - (this->Xz * this->Xz + this->Yz * this->Yz));
  }
  SquaredDistance(const Vector3&, const CenteredSurface::SecondOrderSample& sample,
                  const Vector3& query) noexcept
  {
    this->Aim(sample, query);
    const auto& [first, second] = sample.First;
    const double aa = first.squaredNorm() - this->Offset.dot(sample.Second[0]);
    const double ab = first.dot(second) - this->Offset.dot(sample.Second[1]);
    const double bb = second.squaredNorm() - this->Offset.dot(sample.Second[2]);
    this->Trace = aa + bb;
    this->Determinant = aa * bb - ab * ab;
    const auto& [a, b] = sample.Tangents;
    const Vector3 row = aa * a + ab * b;
    const Vector3 column = ab * a + bb * b;
    this->Xx = row[0] * a[0] + column[0] * b[0];
    this->Xy = row[0] * a[1] + column[0] * b[1];
    this->Xz = row[0] * a[2] + column[0] * b[2];
    this->Yy = row[1] * a[1] + column[1] * b[1];
    this->Yz = row[1] * a[2] + column[1] * b[2];
    this->Zz = row[2] * a[2] + column[2] * b[2];
  }

  /// Changes the query at the same direction. The Hessian is not updated; its error is proportional
  /// to the change.
  void MoveQuery(const Vector3& direction, const RadialModel::SecondOrderSample& sample,
                 const Vector3& query) noexcept
  {
    this->Aim(direction, sample, query);
  }
  void MoveQuery(const Vector3&, const CenteredSurface::SecondOrderSample& sample,
                 const Vector3& query) noexcept
  {
    this->Aim(sample, query);
  }

  /// Whether the Hessian is positive definite in the tangent plane.
  bool IsConvex() const noexcept { return this->Trace > 0.0 && this->Determinant > 0.0; }
  /// The square of half the difference of the Hessian's eigenvalues in the tangent plane.
  double SquaredSpread() const noexcept
  {
    const double half = 0.5 * this->Trace;
    return std::max(0.0, half * half - this->Determinant);
  }
  /// In the tangent plane, mm^2/rad^2; `spread` is the square root of SquaredSpread.
  double SmallestEigenvalue(double spread) const noexcept
  {
    // The root of larger magnitude first, so that the other keeps its digits.
    const double half = 0.5 * this->Trace;
    return half > 0.0 ? this->Determinant / (half + spread) : half - spread;
  }
  double SmallestEigenvalue() const noexcept
  {
    return this->SmallestEigenvalue(std::sqrt(this->SquaredSpread()));
  }

  /// The Newton step (rad, tangent to the sphere); the determinant must not be zero.
  Vector3 NewtonStep() const noexcept
  {
    return (1.0 / this->Determinant) * (this->Image() - this->Trace * this->Gradient);
  }
  /// The same for the function with `shift` times the identity added to its Hessian; that must
  /// leave it positive definite.
  Vector3 ShiftedStep(double shift) const noexcept
  {
    const double sum = this->Trace + shift;
    return (1.0 / (this->Determinant + shift * sum)) * (this->Image() - sum * this->Gradient);
  }

  /// Lower bound (mm^2; at most 0) of the change of the quadratic expansion within the angle
  /// `reach` > 0 (rad); `smallest` is the smallest eigenvalue, `slope` the gradient's length. At
  /// the boundary it is the dual of the problem, which is a lower bound for any shift that leaves
  /// the Hessian positive definite (More and Sorensen, "Computing a trust region step", SIAM J.
  /// Sci. Stat. Comput. 4, 1983); a few shifts come close.
  double LeastChange(double reach, double smallest, double slope) const noexcept
  {
    if (smallest > 0.0)
    {
      const Vector3 step = this->NewtonStep();
      if (step.squaredNorm() <= reach * reach)
      {
        return 0.5 * this->Gradient.dot(step);
      }
    }
    constexpr int Shifts = 3;
    const double least = 1e-6 * std::abs(this->Trace);
    double eigenvalue = slope / reach; // the smallest, with the shift: the step is then no longer
    double change = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < Shifts; ++i)
    {
      const double shift = std::max(0.0, std::max(eigenvalue, least) - smallest);
      const Vector3 step = this->ShiftedStep(shift);
      change = std::max(change, 0.5 * (this->Gradient.dot(step) - shift * reach * reach));
      eigenvalue = (smallest + shift) * step.norm() / reach;
    }
    return change;
  }

  Vector3 Offset;     ///< query - point, mm
  Vector3 Gradient;   ///< mm^2/rad, tangent to the sphere
  double Trace = 0.0; ///< of the Hessian in the tangent plane, mm^2/rad^2
  double Determinant = 0.0;

private:
  // The Hessian applied to the gradient.
  Vector3 Image() const noexcept
  {
    const Vector3& g = this->Gradient;
    return {this->Xx * g[0] + this->Xy * g[1] + this->Xz * g[2],
            this->Xy * g[0] + this->Yy * g[1] + this->Yz * g[2],
            this->Xz * g[0] + this->Yz * g[1] + this->Zz * g[2]};
  }

  struct Parts
  {
    double Along;
    Vector3 Across;
  };

  // Computes everything but the Hessian; returns the parts of q - x.
  Parts Aim(const Vector3& u, const RadialModel::SecondOrderSample& sample,
            const Vector3& query) noexcept
  {
    const double radius = sample.Radius;
    this->Offset = query - radius * u;
    const double along = query.dot(u) - radius * u.squaredNorm();
    const Vector3 across = this->Offset - along * u;
    this->Gradient = -along * sample.SurfaceGradient - radius * across;
    return {along, across};
  }
  void Aim(const CenteredSurface::SecondOrderSample& sample, const Vector3& query) noexcept
  {
    this->Offset = query - sample.Point;
    this->Gradient = -this->Offset.dot(sample.First[0]) * sample.Tangents[0] -
                     this->Offset.dot(sample.First[1]) * sample.Tangents[1];
  }

  double Xx, Yy, Zz, Xy, Xz, Yz; // the Hessian; zero along the direction
};
} // namespace palpate
