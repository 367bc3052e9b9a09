#pragma once

namespace palpate
{
/// Evaluation of the table of one model: by one formulation, with one instruction set. The table's
/// layout depends on the formulation (PolynomialTable, RecurrenceTable) and is the same for every
/// instruction set. Directions are x, y, z. Output for each:
///   values     R,
///   gradients  R and the gradient on the unit sphere (3),
///   Hessians   R, the gradient (3) and the surface Hessian (9, symmetric).
/// A direction is taken as normalised if its squared length is 1 up to rounding; if it differs
/// from 1 by more than 1e-3, the result is NaN.
struct EvaluationKernel
{
  using Single = void (*)(const double* table, int degree, const double* direction,
                          double* sample) noexcept;
  using Batch = void (*)(const double* table, int degree, const double* directions, long count,
                         double* samples) noexcept;

  double (*Value)(const double* table, int degree, const double* direction) noexcept;
  Single Gradient;
  Single Hessian;
  Batch Values;
  Batch Gradients;
  Batch Hessians;
};

/// The same for surfaces x(u), y(u), z(u), by the tables SurfacePolynomialTable and
/// RecurrenceTable. Output, with orthonormal tangents a and b of the sphere at u, three numbers
/// each:
///   Point        X,
///   FirstOrder   X, X_a, X_b, a, b,
///   SecondOrder  X, X_a, X_b, X_aa, X_ab, X_bb, a, b.
struct SurfaceKernel
{
  using Single = void (*)(const double* table, int degree, const double* direction,
                          double* sample) noexcept;

  Single Point;
  Single FirstOrder;
  Single SecondOrder;
};

/// Highest degree that may be evaluated by polynomials: at 17 their error reaches 1e-14.
constexpr int HighestPolynomialDegree = 16;
/// The same for surfaces, where the recurrence takes three times as long as the polynomials: an
/// even degree at which the error is below 1e-12.
constexpr int HighestSurfacePolynomialDegree = 24;

/// Everything that one instruction set offers.
struct EvaluationKernels
{
  /// For tables of degree 0, 2, 4 and so on; half of the degrees is half of the code.
  EvaluationKernel Polynomial[HighestPolynomialDegree / 2 + 1];
  /// For tables of any degree.
  EvaluationKernel Recurrence;
  /// For tables of even degrees up to HighestSurfacePolynomialDegree.
  SurfaceKernel SurfacePolynomial;
  /// For tables of any degree.
  SurfaceKernel SurfaceRecurrence;
};
} // namespace palpate
