#include "PolynomialKernelChoice.h"
#include "PolynomialTable.h"

#include "RandomShapes.h"
#include "SphericalHarmonicModel.h"
#include "WorstCase.h"

#include <array>
#include <gtest/gtest.h>

namespace palpate
{
namespace
{
using test::Random;
using test::WorstCase;
using Formulation = SphericalHarmonicModel::Formulation;
using Four = std::array<double, 4>;

// Coefficients of unit size, so that every term counts; and directions everywhere, at both poles
// and close to them.
struct Case
{
  explicit Case(int degree)
  {
    Random random(static_cast<unsigned>(500 + degree));
    this->Coefficients = test::RandomCoefficients(random, degree);
    this->Directions = test::RandomDirections(random, 203); // no multiple of two or four
    for (const double z : {1.0, -1.0})
    {
      this->Directions.emplace_back(0.0, 0.0, z);
      for (const double off : {1e-4, 1e-8, 1e-15})
      {
        this->Directions.emplace_back(Vector3(off, -0.5 * off, z).normalized());
      }
    }
  }
  std::vector<double> Coefficients;
  std::vector<Vector3> Directions;
};

// Size of a sum of all harmonics with these coefficients, and of its gradient.
double ScaleOf(const std::vector<double>& coefficients, int degree)
{
  double squares = 0.0;
  for (const double c : coefficients)
  {
    squares += c * c;
  }
  return std::sqrt(squares * static_cast<double>((degree + 1) * (degree + 1)) / (4.0 * M_PI));
}

TEST(PolynomialKernel, AgreesWithTheRecurrenceOnEveryInstructionSet)
{
  for (const auto& [name, kernel] : polynomial::RunnableKernels())
  {
    for (int degree = 0; degree <= SphericalHarmonicModel::HighestPolynomialDegree; ++degree)
    {
      const Case c(degree);
      const SphericalHarmonicModel reference(degree, c.Coefficients, Vector3::Zero(),
                                             Formulation::Recurrence);
      const PolynomialTable table(degree, c.Coefficients, kernel->Lanes);
      WorstCase value;
      WorstCase gradient;
      for (const Vector3& u : c.Directions)
      {
        const SphericalHarmonicModel::Sample exact = reference.Evaluate(u);
        Four found{};
        kernel->Evaluate(table.Data(), degree, u.data(), found.data());
        value.Add(found[0] - exact.Radius);
        value.Add(kernel->Radius(table.Data(), degree, u.data()) - exact.Radius);
        for (int k = 0; k < 3; ++k)
        {
          gradient.Add(found[static_cast<std::size_t>(k) + 1] - exact.SurfaceGradient[k]);
        }
      }
      // Both formulations err by some 1e-15 of the sum of all terms; the polynomials' terms grow
      // with the degree before they cancel.
      const double scale = ScaleOf(c.Coefficients, degree);
      EXPECT_LE(value.Value(), 2e-14 * scale) << name << " degree " << degree;
      EXPECT_LE(gradient.Value(), 2e-14 * scale * (degree + 1)) << name << " degree " << degree;
    }
  }
}

TEST(PolynomialKernel, BatchesAgreeWithSingleCallsForEveryCount)
{
  constexpr int Degree = 12;
  const Case c(Degree);
  for (const auto& [name, kernel] : polynomial::RunnableKernels())
  {
    const PolynomialTable table(Degree, c.Coefficients, kernel->Lanes);
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{3}, std::size_t{4},
                                    std::size_t{7}, c.Directions.size()})
    {
      std::vector<Four> samples(count + 1, Four{-1.0, -2.0, -3.0, -4.0});
      kernel->EvaluateBatch(table.Data(), table.End(), Degree, c.Directions.front().data(),
                            static_cast<long>(count), samples.front().data());
      for (std::size_t i = 0; i < count; ++i)
      {
        Four single{};
        kernel->Evaluate(table.Data(), Degree, c.Directions[i].data(), single.data());
        for (std::size_t k = 0; k < 4; ++k)
        {
          // The order of the sums differs: some roundings of terms of size 13.
          ASSERT_NEAR(samples[i][k], single[k], 2e-12) << name;
        }
      }
      ASSERT_EQ(samples[count], (Four{-1.0, -2.0, -3.0, -4.0})) << "written past the end";
    }
  }
}

TEST(PolynomialKernel, GradientIsTangentAndFiniteAtThePoles)
{
  constexpr int Degree = 12;
  const Case c(Degree);
  for (const auto& [name, kernel] : polynomial::RunnableKernels())
  {
    const PolynomialTable table(Degree, c.Coefficients, kernel->Lanes);
    for (const Vector3& u : c.Directions)
    {
      Four found{};
      kernel->Evaluate(table.Data(), Degree, u.data(), found.data());
      const Vector3 gradient(found[1], found[2], found[3]);
      ASSERT_TRUE(gradient.allFinite()) << name;
      ASSERT_NEAR(gradient.dot(u), 0.0, 1e-12) << name;
    }
  }
}

TEST(PolynomialKernel, TheTableOfDegree12FitsInFourKilobytes)
{
  const std::vector<double> coefficients(169, 1.0);
  for (const auto& [name, kernel] : polynomial::RunnableKernels())
  {
    EXPECT_LE(PolynomialTable(12, coefficients, kernel->Lanes).Bytes(), 4096U) << name;
  }
}

TEST(PolynomialKernel, ModelsUseItUpToDegree16AndTheRecurrenceAbove)
{
  Random random(77);
  for (const int degree : {12, 40})
  {
    const std::vector<double> coefficients = test::RandomCoefficients(random, degree, 1.5);
    const SphericalHarmonicModel automatic(degree, coefficients, Vector3::Zero());
    const SphericalHarmonicModel recurrence(degree, coefficients, Vector3::Zero(),
                                            Formulation::Recurrence);
    const std::vector<Vector3> directions = test::RandomDirections(random, 101);
    std::vector<SphericalHarmonicModel::Sample> samples(directions.size());
    automatic.EvaluateBatch(directions.data(), directions.size(), samples.data());
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
      EXPECT_NEAR(samples[i].Radius, recurrence.Radius(directions[i]), 1e-12);
      EXPECT_NEAR(automatic.Radius(directions[i]), recurrence.Radius(directions[i]), 1e-12);
    }
  }
}
} // namespace
} // namespace palpate
