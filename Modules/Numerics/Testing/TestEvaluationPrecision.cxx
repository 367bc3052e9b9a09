#include "ClosestPointSearch.h"
#include "NearestByBruteForce.h"
#include "RandomShapes.h"
#include "WorstCase.h"

#include <gtest/gtest.h>
#include <memory>

namespace palpate
{
namespace
{
using test::Random;
using test::WorstCase;

class EvaluationPrecisionOfDegree : public testing::TestWithParam<int>
{
};

TEST_P(EvaluationPrecisionOfDegree, FloatRadiiAreWithinAssumedRounding)
{
  Random random(static_cast<unsigned>(1700 + GetParam()));
  for (int body = 0; body < 5; ++body)
  {
    const SphericalHarmonicModel exact = test::RandomRough(random, GetParam(), 20.0);
    const SphericalHarmonicModel rounded = exact.WithPrecision(EvaluationPrecision::Float);
    const double rounding = ClosestPointDescent(rounded).Rounding(Vector3::Zero());
    WorstCase difference;
    for (const Vector3& u : test::RandomDirections(random, 2000))
    {
      difference.Add(exact.Radius(u) - rounded.Radius(u));
      difference.Add(exact.Evaluate(u).Radius - rounded.Evaluate(u).Radius);
      difference.Add(exact.EvaluateSecondOrder(u).Radius - rounded.EvaluateSecondOrder(u).Radius);
    }
    EXPECT_GT(difference.Value(), 0.0);
    EXPECT_LE(difference.Value(), rounding);
  }
}

TEST_P(EvaluationPrecisionOfDegree, FloatClosestPointIsWithinItsError)
{
  Random random(static_cast<unsigned>(1750 + GetParam()));
  const auto exact =
      std::make_shared<const SphericalHarmonicModel>(test::RandomRough(random, GetParam(), 20.0));
  const ClosestPointSearch inDouble(exact);
  const ClosestPointSearch inFloat(std::make_shared<const SphericalHarmonicModel>(
      exact->WithPrecision(EvaluationPrecision::Float)));
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 u = test::RandomDirection(random);
    const Vector3 query = exact->PointWorld(u) + 3.0 * test::RandomDirection(random);
    const ClosestPoint truth = inDouble.Nearest(query, 20000);
    const ClosestPoint found = inFloat.Nearest(query);
    // The found point is evaluated in float, so its distance may be too small as well.
    const double rounding = inFloat.Descent().Rounding(query - exact->CenterWorld());
    const double excess = std::abs(found.SignedDistance) - std::abs(truth.SignedDistance);
    ASSERT_LE(excess, found.DistanceError + rounding);
    ASSERT_GE(excess, -rounding);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, EvaluationPrecisionOfDegree, testing::Values(4, 12, 16, 20, 33));

TEST(EvaluationPrecision, ReturnToDoubleRestoresModel)
{
  Random random(1790);
  const SphericalHarmonicModel exact = test::RandomOrgan(random, 12);
  const SphericalHarmonicModel single = exact.WithPrecision(EvaluationPrecision::Float);
  EXPECT_EQ(single.Precision(), EvaluationPrecision::Float);
  EXPECT_EQ(2 * single.TableBytes(), exact.TableBytes());
  const SphericalHarmonicModel back = single.WithPrecision(EvaluationPrecision::Double);
  EXPECT_EQ(back.Precision(), EvaluationPrecision::Double);
  const Vector3 u = test::RandomDirection(random);
  EXPECT_EQ(back.Radius(u), exact.Radius(u));
  EXPECT_NE(single.Radius(u), exact.Radius(u));
}
} // namespace
} // namespace palpate
