#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace palpate::bench
{
/// Evaluating many directions and comparing what came out. A result is a radius or one of the
/// samples of a SphericalHarmonicEvaluator.

/// A number that depends on all of a result, for the next direction to wait for.
template <typename Result>
auto LastNumber(const Result& result)
{
  if constexpr (std::is_floating_point_v<Result>)
  {
    return result;
  }
  else if constexpr (sizeof(Result) == 4 * sizeof(result.Radius))
  {
    return result.Radius + result.SurfaceGradient.z();
  }
  else
  {
    return result.Radius + result.SurfaceHessian(2, 2);
  }
}

/// One call after the other.
template <typename Vector, typename Result, typename Evaluate>
void RunIndependent(const std::vector<Vector>& directions, std::vector<Result>& results,
                    const Evaluate& evaluate)
{
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    results[i] = evaluate(directions[i]);
  }
}

/// Each direction waits for the last result, as in an iterative search.
template <typename Vector, typename Result, typename Evaluate>
void RunChained(const std::vector<Vector>& directions, std::vector<Result>& results,
                const Evaluate& evaluate)
{
  typename Vector::Scalar last = 0;
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    Vector direction = directions[i];
    direction.x() += 0 * last;
    results[i] = evaluate(direction);
    last = static_cast<typename Vector::Scalar>(LastNumber(results[i]));
  }
}

/// The largest difference of two results, that of the second derivatives divided by 100, since they
/// are so much larger.
template <typename A, typename B>
double Difference(const A& a, const B& b)
{
  if constexpr (std::is_floating_point_v<A>)
  {
    return std::abs(static_cast<double>(a) - static_cast<double>(b));
  }
  else
  {
    double largest = Difference(a.Radius, b.Radius);
    const double gradient =
        (a.SurfaceGradient.template cast<double>() - b.SurfaceGradient.template cast<double>())
            .norm();
    largest = std::isnan(gradient) ? gradient : std::max(largest, gradient);
    if constexpr (sizeof(A) > 4 * sizeof(a.Radius))
    {
      const double hessian =
          (a.SurfaceHessian.template cast<double>() - b.SurfaceHessian.template cast<double>())
              .norm();
      largest = std::isnan(hessian) ? hessian : std::max(largest, hessian / 100.0);
    }
    return largest;
  }
}

/// Empty if all results agree within `tolerance` (mm).
template <typename A, typename B>
std::string Disagreement(const std::vector<A>& ours, const std::vector<B>& theirs, double tolerance)
{
  for (std::size_t i = 0; i < ours.size(); ++i)
  {
    const double difference = Difference(ours[i], theirs[i]);
    if (!(difference <= tolerance))
    {
      std::ostringstream text;
      text << "results differ by " << difference << " mm";
      return text.str();
    }
  }
  return {};
}
} // namespace palpate::bench
