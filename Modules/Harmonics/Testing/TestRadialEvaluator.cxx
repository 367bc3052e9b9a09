#include "RadialEvaluator.h"

#include "EvaluatorCases.h"
#include "SphericalHarmonicBasis.h"
#include "TextbookHarmonics.h"
#include "WorstCase.h"

#include <gtest/gtest.h>
#include <numeric>
#include <thread>

namespace palpate::spherical_harmonic_evaluator_test
{
namespace
{
using test::AllEvaluatorKinds;
using test::EvaluatorCase;
using test::EvaluatorKind;
using test::WorstCase;

RadialEvaluator Make(const EvaluatorCase& c, const EvaluatorKind& kind)
{
  return {c.Degree, c.Coefficients, kind.Formulation, kind.Set};
}

long double TextbookRadius(const EvaluatorCase& c, const Vector3& u)
{
  long double sum = 0.0L;
  for (int l = 0; l <= c.Degree; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      sum += c.Coefficients[SphericalHarmonicBasis::Index(l, m)] * test::TextbookReal(l, m, u);
    }
  }
  return sum;
}

TEST(RadialEvaluator, AllKindsEqualTextbookSum)
{
  for (const int degree : {0, 1, 2, 3, 4, 5, 7, 8, 9, 12, 13, 15, 16, 17, 30})
  {
    const EvaluatorCase c(degree);
    std::vector<long double> exact;
    for (const Vector3& u : c.Directions)
    {
      exact.push_back(TextbookRadius(c, u));
    }
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const RadialEvaluator evaluator = Make(c, kind);
      WorstCase worst;
      for (std::size_t i = 0; i < exact.size(); ++i)
      {
        const Vector3& u = c.Directions[i];
        worst.Add(static_cast<double>(evaluator.Radius(u) - exact[i]));
        worst.Add(static_cast<double>(evaluator.Evaluate(u).Radius - exact[i]));
        worst.Add(static_cast<double>(evaluator.EvaluateSecondOrder(u).Radius - exact[i]));
      }
      // The documented bound; measured 2e-15 at degree 16.
      EXPECT_LE(worst.Value(), 1e-14 * c.Scale()) << kind.Name() << " degree " << degree;
    }
  }
}

TEST(RadialEvaluator, GradientMatchesFiniteDifference)
{
  for (const int degree : {1, 6, 16})
  {
    const EvaluatorCase c(degree);
    const RadialEvaluator evaluator(degree, c.Coefficients);
    WorstCase worst;
    for (std::size_t i = 0; i < c.Directions.size(); i += 5)
    {
      const Vector3& u = c.Directions[i];
      const Vector3 tangent = u.unitOrthogonal();
      const auto at = [&](double angle)
      { return TextbookRadius(c, std::cos(angle) * u + std::sin(angle) * tangent); };
      constexpr double H = 1e-3; // rad
      const long double difference = (8 * (at(H) - at(-H)) - (at(2 * H) - at(-2 * H))) / (12 * H);
      worst.Add(evaluator.Evaluate(u).SurfaceGradient.dot(tangent) -
                static_cast<double>(difference));
    }
    // The formula's error is H^4 / 30 times a fifth derivative, 16^4 = 7e4 times the gradient's
    // size; the directions' rounding, 1e-16 / H, is smaller.
    EXPECT_LE(worst.Value(), 3e-9 * c.GradientScale()) << degree;
  }
}

TEST(RadialEvaluator, DerivativesOfAllKindsAgree)
{
  for (int degree = 0; degree <= 18; ++degree)
  {
    const EvaluatorCase c(degree);
    const RadialEvaluator reference(degree, c.Coefficients, EvaluationFormulation::Recurrence,
                                    InstructionSet::Portable);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const RadialEvaluator evaluator = Make(c, kind);
      WorstCase gradient;
      WorstCase hessian;
      for (const Vector3& u : c.Directions)
      {
        const RadialEvaluator::SecondOrderSample exact = reference.EvaluateSecondOrder(u);
        const RadialEvaluator::SecondOrderSample found = evaluator.EvaluateSecondOrder(u);
        gradient.Add((evaluator.Evaluate(u).SurfaceGradient - exact.SurfaceGradient).norm());
        gradient.Add((found.SurfaceGradient - exact.SurfaceGradient).norm());
        hessian.Add((found.SurfaceHessian - exact.SurfaceHessian).norm());
      }
      // Twice the documented bound, as both sides may be off.
      EXPECT_LE(gradient.Value(), 2e-14 * c.GradientScale()) << kind.Name() << ' ' << degree;
      EXPECT_LE(hessian.Value(), 2e-14 * c.HessianScale()) << kind.Name() << ' ' << degree;
    }
  }
}

TEST(RadialEvaluator, GradientAndHessianAreTangent)
{
  const EvaluatorCase c(12);
  for (const EvaluatorKind& kind : AllEvaluatorKinds())
  {
    const RadialEvaluator evaluator = Make(c, kind);
    for (const Vector3& u : c.Directions)
    {
      const RadialEvaluator::SecondOrderSample s = evaluator.EvaluateSecondOrder(u);
      // Roundings of numbers of this size.
      EXPECT_LE(std::abs(evaluator.Evaluate(u).SurfaceGradient.dot(u)), 1e-14 * c.GradientScale());
      EXPECT_LE(std::abs(s.SurfaceGradient.dot(u)), 1e-14 * c.GradientScale());
      EXPECT_LE((s.SurfaceHessian * u).norm(), 1e-14 * c.HessianScale());
      EXPECT_EQ(s.SurfaceHessian, s.SurfaceHessian.transpose());
    }
  }
}

TEST(RadialEvaluator, TraceOfHessianIsLaplacian)
{
  const EvaluatorCase c(12);
  EvaluatorCase laplacian = c;
  for (int l = 0; l <= c.Degree; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      laplacian.Coefficients[SphericalHarmonicBasis::Index(l, m)] *= -l * (l + 1.0);
    }
  }
  for (const EvaluatorKind& kind : AllEvaluatorKinds())
  {
    const RadialEvaluator evaluator = Make(c, kind);
    const RadialEvaluator exact = Make(laplacian, kind);
    for (const Vector3& u : c.Directions)
    {
      EXPECT_NEAR(evaluator.EvaluateSecondOrder(u).SurfaceHessian.trace(), exact.Radius(u),
                  1e-14 * c.HessianScale())
          << kind.Name();
    }
  }
}

TEST(RadialEvaluator, HighDegreesAreFiniteEverywhereAndAgree)
{
  // 300 and 1000 pass the range of double in powers of sin theta.
  for (const int degree : {300, 1000})
  {
    const EvaluatorCase c(degree);
    const SphericalHarmonicBasis basis(degree);
    const RadialEvaluator portable(degree, c.Coefficients, EvaluationFormulation::Automatic,
                                   InstructionSet::Portable);
    const RadialEvaluator fastest(degree, c.Coefficients);
    std::vector<double> values(basis.Size());
    for (std::size_t i = 0; i < c.Directions.size(); i += degree == 1000 ? 4 : 1)
    {
      const Vector3& u = c.Directions[i];
      basis.Evaluate(u, values.data());
      const long double exact =
          std::inner_product(values.begin(), values.end(), c.Coefficients.begin(), 0.0L);
      const RadialEvaluator::Sample sample = fastest.Evaluate(u);
      // The promise is 1e-12 against 50 digits; two sums in double, each good to that.
      EXPECT_NEAR(sample.Radius, static_cast<double>(exact), 2e-12 * c.Scale());
      EXPECT_NEAR(portable.Radius(u), static_cast<double>(exact), 2e-12 * c.Scale());
      EXPECT_LE((sample.SurfaceGradient - portable.Evaluate(u).SurfaceGradient).norm(),
                2e-12 * c.GradientScale());
      EXPECT_TRUE(fastest.EvaluateSecondOrder(u).SurfaceHessian.allFinite());
    }
  }
}

TEST(RadialEvaluator, HugeHarmonicDoesNotOverflow)
{
  // The column of order 150 starts near a pole at 1e-300 and grows back.
  constexpr int Degree = 400;
  std::vector<double> coefficients(SphericalHarmonicBasis::CoefficientCount(Degree), 0.0);
  const std::size_t index = SphericalHarmonicBasis::Index(Degree, 150);
  coefficients[index] = 1e150;
  const RadialEvaluator evaluator(Degree, coefficients);
  const SphericalHarmonicBasis basis(Degree);
  std::vector<double> values(basis.Size());
  for (const double sine : {1e-4, 1e-2, 0.1, 0.3, 0.6})
  {
    const Vector3 u = Vector3(sine, 0.01 * sine, 1.0).normalized();
    basis.Evaluate(u, values.data());
    EXPECT_NEAR(evaluator.Radius(u) * 1e-150, values[index], 1e-12); // of a harmonic of size 8
    EXPECT_NEAR(values[index], static_cast<double>(test::TextbookReal(Degree, 150, u)), 1e-12);
  }
}

TEST(RadialEvaluator, InvalidDirectionGivesNan)
{
  const double nan = std::nan("");
  const std::vector<Vector3> wrong{
      {0, 0, 0},         {nan, 0, 1},  {0, nan, 1},    {0, 0, nan},     {INFINITY, 0, 0},
      {0, 0, -INFINITY}, {0, 0, 1.01}, {1e-200, 0, 0}, {0.5, 0.5, 0.5}, {1e200, 0, 0}};
  for (const int degree : {0, 1, 4, 12, 20})
  {
    const EvaluatorCase c(degree);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const RadialEvaluator evaluator = Make(c, kind);
      for (const Vector3& u : wrong)
      {
        const RadialEvaluator::SecondOrderSample s = evaluator.EvaluateSecondOrder(u);
        const RadialEvaluator::Sample g = evaluator.Evaluate(u);
        EXPECT_TRUE(std::isnan(evaluator.Radius(u))) << kind.Name() << ' ' << u.transpose();
        EXPECT_TRUE(std::isnan(s.Radius) && std::isnan(g.Radius)) << kind.Name();
        EXPECT_TRUE(g.SurfaceGradient.array().isNaN().all()) << kind.Name() << ' ' << degree;
        EXPECT_TRUE(s.SurfaceGradient.array().isNaN().all()) << kind.Name() << ' ' << degree;
        EXPECT_TRUE(s.SurfaceHessian.array().isNaN().all()) << kind.Name() << ' ' << degree;
      }
    }
  }
}

TEST(RadialEvaluator, RoundedLengthChangesNothing)
{
  for (const int degree : {1, 12, 16, 30})
  {
    const EvaluatorCase c(degree);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const RadialEvaluator evaluator = Make(c, kind);
      for (const Vector3& u : c.Directions)
      {
        for (const double longer : {3e-16, -3e-16, 1e-8, -1e-8})
        {
          const auto s = evaluator.EvaluateSecondOrder(u);
          const auto off = evaluator.EvaluateSecondOrder((1.0 + longer) * u);
          // In addition to the error of both, the rounding of each coordinate turns the direction.
          EXPECT_NEAR(off.Radius, s.Radius, 3e-14 * c.Scale() + 2e-16 * c.GradientScale());
          EXPECT_LE((off.SurfaceGradient - s.SurfaceGradient).norm(),
                    3e-14 * c.GradientScale() + 2e-16 * c.HessianScale());
        }
      }
    }
  }
}

TEST(RadialEvaluator, ThreadsGetSameBits)
{
  const EvaluatorCase c(12);
  const RadialEvaluator evaluator(12, c.Coefficients);
  const auto evaluateAll = [&]
  {
    std::vector<double> numbers;
    for (int repeat = 0; repeat < 50; ++repeat)
    {
      for (const Vector3& u : c.Directions)
      {
        const RadialEvaluator::SecondOrderSample s = evaluator.EvaluateSecondOrder(u);
        numbers.insert(numbers.end(), {evaluator.Radius(u), s.SurfaceGradient.sum(),
                                       evaluator.Evaluate(u).Radius, s.SurfaceHessian.sum()});
      }
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
  const std::vector<double> alone = evaluateAll();
  for (const std::vector<double>& result : results)
  {
    EXPECT_EQ(result, alone);
  }
}

TEST(RadialEvaluator, TableOfDegree12FitsInFourKilobytes)
{
  const std::vector<double> coefficients(169, 1.0);
  EXPECT_LE(RadialEvaluator(12, coefficients).TableBytes(), 4096U);
}
} // namespace
} // namespace palpate::spherical_harmonic_evaluator_test
