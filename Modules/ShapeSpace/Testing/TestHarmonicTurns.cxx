#include "HarmonicTurns.h"

#include "RandomShapes.h"

#include <gtest/gtest.h>

namespace palpate::harmonic_turns_test
{
namespace
{
using test::Random;

constexpr int Degree = 9;
constexpr Eigen::Index Count = (Degree + 1) * (Degree + 1);

Eigen::VectorXd HarmonicsAt(const Vector3& direction)
{
  Eigen::VectorXd values(Count);
  SphericalHarmonicBasis(Degree).Evaluate(direction, values.data());
  return values;
}

Eigen::VectorXd SomeCoefficients(Random& random)
{
  const std::vector<double> values = test::RandomCoefficients(random, Degree);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), Count);
}

TEST(HarmonicTurns, AreDerivativesByTurningTheDirection)
{
  Random random(1);
  const HarmonicTurns turns(Degree);
  for (int n = 0; n < 100; ++n)
  {
    const Eigen::VectorXd coefficients = SomeCoefficients(random);
    // The poles, too.
    const Vector3 direction = n % 10 == 0 ? Vector3::UnitZ() : test::RandomDirection(random);
    const Vector3 axis = test::RandomDirection(random);
    Eigen::VectorXd turned(Count);
    turns.Turn(axis, coefficients.data(), turned.data());
    constexpr double Step = 1e-4; // rad: an error of (L Step)^2 / 6, 1e-7 relative
    const auto at = [&](double angle)
    { return coefficients.dot(HarmonicsAt(Eigen::AngleAxisd(angle, axis) * direction)); };
    const double difference = (at(Step) - at(-Step)) / (2.0 * Step);
    EXPECT_NEAR(turned.dot(HarmonicsAt(direction)), difference, 1e-5);
  }
}

TEST(HarmonicTurns, AreAntisymmetric)
{
  Random random(2);
  const HarmonicTurns turns(Degree);
  const Eigen::VectorXd one = SomeCoefficients(random);
  const Eigen::VectorXd other = SomeCoefficients(random);
  const Vector3 axis(0.3, -2.0, 1.1);
  Eigen::VectorXd oneTurned(Count);
  Eigen::VectorXd otherTurned(Count);
  turns.Turn(axis, one.data(), oneTurned.data());
  turns.Turn(axis, other.data(), otherTurned.data());
  EXPECT_NEAR(one.dot(otherTurned), -other.dot(oneTurned), 1e-10);
}
} // namespace
} // namespace palpate::harmonic_turns_test
