#include "SurfaceEvaluator.h"

#include "SphericalHarmonicBasis.h"
#include "SurfaceCases.h"
#include "TextbookHarmonics.h"
#include "WorstCase.h"

#include <cstring>
#include <gtest/gtest.h>
#include <thread>

namespace palpate::parametric_surface_evaluator_test
{
namespace
{
using test::AllEvaluatorKinds;
using test::EvaluatorKind;
using test::SurfaceCase;
using test::WorstCase;
using Evaluator = SurfaceEvaluator;

Evaluator Make(const SurfaceCase& c, const EvaluatorKind& kind)
{
  return {c.Degree, c.Coefficients, kind.Formulation, kind.Set};
}

long double TextbookSum(int degree, const std::vector<double>& coefficients, const Vector3& u)
{
  long double sum = 0.0L;
  for (int l = 0; l <= degree; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      sum += coefficients[SphericalHarmonicBasis::Index(l, m)] * test::TextbookReal(l, m, u);
    }
  }
  return sum;
}

TEST(SurfaceEvaluator, AllKindsEqualTextbookSums)
{
  for (const int degree : {0, 1, 2, 3, 7, 12, 16, 20, 24, 25})
  {
    const SurfaceCase c(degree);
    for (std::size_t i = 0; i<c.Directions().size(); i += degree> 16 ? 3 : 1)
    {
      const Vector3& u = c.Directions()[i];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const long double exact = TextbookSum(degree, c.Coefficients[k], u);
        const double bound = c.Bound() * c.Axis[k].Scale();
        for (const EvaluatorKind& kind : AllEvaluatorKinds())
        {
          const Evaluator evaluator = Make(c, kind);
          const auto at = static_cast<Eigen::Index>(k);
          WorstCase worst;
          worst.Add(static_cast<double>(evaluator.Point(u)[at] - exact));
          worst.Add(static_cast<double>(evaluator.Evaluate(u).Point[at] - exact));
          worst.Add(static_cast<double>(evaluator.EvaluateSecondOrder(u).Point[at] - exact));
          ASSERT_LE(worst.Value(), bound) << kind.Name() << " degree " << degree;
        }
      }
    }
  }
}

TEST(SurfaceEvaluator, SingleHarmonicsKeepTheBoundUpToHighestPolynomialDegree)
{
  // The worst case of the polynomials is one harmonic of middle order, at the equator.
  for (const int degree : {16, HighestSurfacePolynomialDegree})
  {
    const std::vector<Vector3> directions = SurfaceCase(degree).Directions();
    const SurfaceCase c(degree);
    for (int m = 0; m <= degree; ++m)
    {
      const std::vector<double> zeros(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
      Evaluator::Coefficients single{zeros, zeros, zeros};
      single[1][SphericalHarmonicBasis::Index(degree, m)] = 1.0;
      const Evaluator polynomials(degree, single);
      const Evaluator recurrence(degree, single, EvaluationFormulation::Recurrence);
      WorstCase worst;
      for (const Vector3& u : directions)
      {
        worst.Add((polynomials.Point(u) - recurrence.Point(u)).norm());
      }
      EXPECT_LE(worst.Value(), c.Bound() * (degree + 1) / std::sqrt(4.0 * M_PI)) << degree << m;
    }
  }
}

TEST(SurfaceEvaluator, DerivativesEqualThoseOfSeparateSeries)
{
  for (const int degree : {0, 1, 2, 5, 8, 12, 15, 16, 19, 24, 25, 40})
  {
    const SurfaceCase c(degree);
    std::vector<RadialEvaluator> axes;
    for (const std::vector<double>& coefficients : c.Coefficients)
    {
      axes.emplace_back(degree, coefficients, EvaluationFormulation::Recurrence,
                        InstructionSet::Portable);
    }
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const Evaluator evaluator = Make(c, kind);
      for (const Vector3& u : c.Directions())
      {
        const Evaluator::SecondOrderSample s = evaluator.EvaluateSecondOrder(u);
        const auto& [a, b] = s.Tangents;
        for (std::size_t k = 0; k < 3; ++k)
        {
          const auto at = static_cast<Eigen::Index>(k);
          const auto exact = axes[k].EvaluateSecondOrder(u);
          WorstCase first;
          first.Add(s.First[0][at] - exact.SurfaceGradient.dot(a));
          first.Add(s.First[1][at] - exact.SurfaceGradient.dot(b));
          WorstCase second;
          second.Add(s.Second[0][at] - a.dot(exact.SurfaceHessian * a));
          second.Add(s.Second[1][at] - a.dot(exact.SurfaceHessian * b));
          second.Add(s.Second[2][at] - b.dot(exact.SurfaceHessian * b));
          // Twice the documented bound, as both sides may be off.
          ASSERT_LE(first.Value(), 2 * c.Bound() * c.Axis[k].GradientScale()) << kind.Name();
          ASSERT_LE(second.Value(), 2 * c.Bound() * c.Axis[k].HessianScale()) << kind.Name();
        }
      }
    }
  }
}

TEST(SurfaceEvaluator, DerivativesMatchFiniteDifferences)
{
  const SurfaceCase c(6);
  const Evaluator evaluator(6, c.Coefficients);
  constexpr double H = 1e-3; // rad
  for (const Vector3& u : c.Directions())
  {
    const Evaluator::SecondOrderSample s = evaluator.EvaluateSecondOrder(u);
    const Vector3 tangent = 0.6 * s.Tangents[0] + 0.8 * s.Tangents[1];
    const auto at = [&](double angle)
    { return evaluator.Point(std::cos(angle) * u + std::sin(angle) * tangent); };
    const Vector3 slope = (8 * (at(H) - at(-H)) - (at(2 * H) - at(-2 * H))) / (12 * H);
    const Vector3 bend = (at(H) + at(-H) - 2 * s.Point) / (H * H);
    // Errors of the formulas: H^4 / 30 and H^2 / 12 times 6^4 and 6^2 times the derivative's size.
    EXPECT_LE((0.6 * s.First[0] + 0.8 * s.First[1] - slope).norm(),
              1e-9 * c.Axis[0].GradientScale());
    EXPECT_LE((0.36 * s.Second[0] + 0.96 * s.Second[1] + 0.64 * s.Second[2] - bend).norm(),
              1e-5 * c.Axis[0].HessianScale());
  }
}

TEST(SurfaceEvaluator, TangentsAreOrthonormalAndRightHanded)
{
  for (const int degree : {4, 30})
  {
    const SurfaceCase c(degree);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const Evaluator evaluator = Make(c, kind);
      for (const Vector3& u : c.Directions())
      {
        const Evaluator::Sample s = evaluator.Evaluate(u);
        EXPECT_EQ(s.Tangents, evaluator.EvaluateSecondOrder(u).Tangents);
        // A few roundings, and those of u itself.
        EXPECT_NEAR(s.Tangents[0].squaredNorm(), 1.0, 3e-15);
        EXPECT_NEAR(s.Tangents[1].squaredNorm(), 1.0, 3e-15);
        EXPECT_NEAR(s.Tangents[0].dot(s.Tangents[1]), 0.0, 2e-15);
        EXPECT_LE((s.Tangents[0].cross(s.Tangents[1]) - u).norm(), 3e-15);
      }
    }
  }
}

TEST(SurfaceEvaluator, HighDegreesAreFiniteEverywhereAndAgree)
{
  // 300 and 1000 pass the range of double in powers of sin theta.
  for (const int degree : {300, 1000})
  {
    const SurfaceCase c(degree);
    const Evaluator fastest(degree, c.Coefficients);
    const RadialEvaluator axis(degree, c.Coefficients[2], EvaluationFormulation::Automatic,
                               InstructionSet::Portable);
    for (std::size_t i = 0; i < c.Directions().size(); i += degree == 1000 ? 5 : 1)
    {
      const Vector3& u = c.Directions()[i];
      const Evaluator::SecondOrderSample s = fastest.EvaluateSecondOrder(u);
      const RadialEvaluator::Sample exact = axis.Evaluate(u);
      // Two sums in double, each good to 1e-12.
      EXPECT_NEAR(s.Point.z(), exact.Radius, 2e-12 * c.Axis[2].Scale());
      EXPECT_NEAR(s.First[0].z(), exact.SurfaceGradient.dot(s.Tangents[0]),
                  2e-12 * c.Axis[2].GradientScale());
      EXPECT_TRUE(s.Second[0].allFinite() && s.Second[1].allFinite() && s.Second[2].allFinite());
    }
  }
}

TEST(SurfaceEvaluator, InvalidParameterGivesNan)
{
  const double nan = std::nan("");
  const std::vector<Vector3> wrong{
      {0, 0, 0},         {nan, 0, 1},  {0, nan, 1},    {0, 0, nan},     {INFINITY, 0, 0},
      {0, 0, -INFINITY}, {0, 0, 1.01}, {1e-200, 0, 0}, {0.5, 0.5, 0.5}, {1e200, 0, 0}};
  for (const int degree : {0, 1, 4, 12, 20, 30})
  {
    const SurfaceCase c(degree);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const Evaluator evaluator = Make(c, kind);
      for (const Vector3& u : wrong)
      {
        EXPECT_TRUE(evaluator.Point(u).array().isNaN().all()) << kind.Name() << u.transpose();
        const Evaluator::Sample first = evaluator.Evaluate(u);
        const Evaluator::SecondOrderSample second = evaluator.EvaluateSecondOrder(u);
        double numbers[15 + 24];
        std::memcpy(numbers, &first, sizeof(first));
        std::memcpy(numbers + 15, &second, sizeof(second));
        for (const double number : numbers)
        {
          EXPECT_TRUE(std::isnan(number)) << kind.Name() << ' ' << degree << ' ' << u.transpose();
        }
      }
    }
  }
}

TEST(SurfaceEvaluator, RoundedLengthChangesNothing)
{
  for (const int degree : {1, 12, 20, 30})
  {
    const SurfaceCase c(degree);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const Evaluator evaluator = Make(c, kind);
      for (const Vector3& u : c.Directions())
      {
        for (const double longer : {3e-16, 1e-8, -1e-8})
        {
          // In addition to the error of both, the rounding of each coordinate turns the parameter.
          EXPECT_LE((evaluator.Point((1.0 + longer) * u) - evaluator.Point(u)).norm(),
                    3 * c.Bound() * c.Axis[0].Scale() + 1e-15 * c.Axis[0].GradientScale());
        }
      }
    }
  }
}

template <typename Sample>
bool HasSameBits(const Sample& a, const Sample& b)
{
  return std::memcmp(&a, &b, sizeof(Sample)) == 0;
}

TEST(SurfaceEvaluator, BatchesHaveTheBitsOfSingleCalls)
{
  for (const int degree : {0, 3, 12, 20, 30})
  {
    const SurfaceCase c(degree);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const Evaluator evaluator = Make(c, kind);
      const std::vector<Vector3>& directions = c.Directions();
      std::vector<Vector3> points(directions.size());
      std::vector<Evaluator::Sample> samples(directions.size());
      std::vector<Evaluator::SecondOrderSample> seconds(directions.size());
      evaluator.PointBatch(directions.data(), directions.size(), points.data());
      evaluator.EvaluateBatch(directions.data(), directions.size(), samples.data());
      evaluator.EvaluateSecondOrderBatch(directions.data(), directions.size(), seconds.data());
      for (std::size_t i = 0; i < directions.size(); ++i)
      {
        EXPECT_TRUE(HasSameBits(points[i], evaluator.Point(directions[i])));
        EXPECT_TRUE(HasSameBits(samples[i], evaluator.Evaluate(directions[i])));
        EXPECT_TRUE(HasSameBits(seconds[i], evaluator.EvaluateSecondOrder(directions[i])));
      }
    }
  }
}

TEST(SurfaceEvaluator, ThreadsGetSameBits)
{
  const SurfaceCase c(12);
  const Evaluator evaluator(12, c.Coefficients);
  const auto evaluateAll = [&]
  {
    std::vector<double> numbers;
    for (const Vector3& u : c.Directions())
    {
      const Evaluator::SecondOrderSample s = evaluator.EvaluateSecondOrder(u);
      numbers.insert(numbers.end(), s.Point.data(), s.Point.data() + 24);
    }
    return numbers;
  };
  std::vector<std::vector<double>> results(4);
  std::vector<std::thread> threads;
  threads.reserve(results.size());
  for (std::vector<double>& result : results)
  {
    threads.emplace_back([&] { result = evaluateAll(); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const std::vector<double>& result : results)
  {
    EXPECT_EQ(result, evaluateAll());
  }
}

TEST(SurfaceEvaluator, TablesFitInTheCache)
{
  const std::vector<double> twelve(169, 1.0);
  const std::vector<double> twenty(441, 1.0);
  EXPECT_LE(Evaluator(12, {twelve, twelve, twelve}).TableBytes(), 5000U);
  EXPECT_LE(Evaluator(20, {twenty, twenty, twenty}).TableBytes(), 12000U);
}
} // namespace
} // namespace palpate::parametric_surface_evaluator_test
