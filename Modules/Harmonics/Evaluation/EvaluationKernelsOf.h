#pragma once

#include "EvaluationKernel.h"
#include "PolynomialBatch.h"
#include "PolynomialPoint.h"
#include "RecurrencePoint.h"
#include "SurfacePolynomialPoint.h"
#include "SurfaceRecurrencePoint.h"

// The rule of Quartet.h applies here too.

namespace palpate::evaluation
{
template <typename Set, int Degree>
constexpr EvaluationKernel PolynomialKernel()
{
  using Point = PolynomialPoint<Set, Degree>;
  return {Point::Value,
          Point::Gradient,
          Point::Hessian,
          PolynomialBatch<Set, 0>::Evaluate,
          PolynomialBatch<Set, 1>::Evaluate,
          PolynomialBatch<Set, 2>::Evaluate};
}

/// All that there is for one instruction set.
template <typename Set>
constexpr EvaluationKernels KernelsOf()
{
  using Point = RecurrencePoint<Set>;
  static_assert(HighestPolynomialDegree == 16, "the degrees are written out");
  return {{PolynomialKernel<Set, 0>(), PolynomialKernel<Set, 2>(), PolynomialKernel<Set, 4>(),
           PolynomialKernel<Set, 6>(), PolynomialKernel<Set, 8>(), PolynomialKernel<Set, 10>(),
           PolynomialKernel<Set, 12>(), PolynomialKernel<Set, 14>(), PolynomialKernel<Set, 16>()},
          {Point::Value, Point::Gradient, Point::Hessian, Point::Values, Point::Gradients,
           Point::Hessians},
          {SurfacePolynomialPoint<Set, 0>::Evaluate, SurfacePolynomialPoint<Set, 1>::Evaluate,
           SurfacePolynomialPoint<Set, 2>::Evaluate},
          {SurfaceRecurrencePoint<Set, 0>::Evaluate, SurfaceRecurrencePoint<Set, 1>::Evaluate,
           SurfaceRecurrencePoint<Set, 2>::Evaluate}};
}
} // namespace palpate::evaluation
