#pragma once

namespace palpate
{
/// How a table of one model is evaluated: by one formulation, with one instruction set. The table's
/// layout belongs to the formulation (PolynomialTable, RecurrenceTable) and is the same for every
/// instruction set. Directions are x, y, z. What is written for each:
///   values     R,
///   gradients  R and the gradient on the unit sphere (3),
///   Hessians   R, the gradient (3) and the surface Hessian (9, symmetric).
/// A direction counts as exactly normalised if its squared length is 1 to a rounding; where it
/// differs from 1 by more than 1e-3, not-a-number is written.
template <typename Real>
struct EvaluationKernel
{
  using Single = void (*)(const Real* table, int degree, const Real* direction,
                          Real* sample) noexcept;
  using Batch = void (*)(const Real* table, int degree, const Real* directions, long count,
                         Real* samples) noexcept;

  Real (*Value)(const Real* table, int degree, const Real* direction) noexcept;
  Single Gradient;
  Single Hessian;
  Batch Values;
  Batch Gradients;
  Batch Hessians;
};

/// Up to this degree a model may be evaluated by polynomials: at 17 they leave 1e-14.
constexpr int HighestPolynomialDegree = 16;

/// Everything that one instruction set offers for one precision.
template <typename Real>
struct EvaluationKernels
{
  /// For tables of degree 0, 2, 4 and so on; half of the degrees is half of the code.
  EvaluationKernel<Real> Polynomial[HighestPolynomialDegree / 2 + 1];
  /// For tables of any degree.
  EvaluationKernel<Real> Recurrence;
};
} // namespace palpate
