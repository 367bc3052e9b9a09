#include "LatitudeSynthesis.h"

#include "RandomShapes.h"
#include "WorstCase.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::latitude_synthesis_test
{
namespace
{
using Sample = RadialModel::Sample;

// Largest difference from single evaluations on a circle.
double Difference(const RadialModel& model, int longitudes, double z)
{
  LatitudeSynthesis circle(model, longitudes);
  const std::vector<Sample>& samples = circle.Evaluate(z);
  test::WorstCase worst;
  for (std::size_t j = 0; j < samples.size(); ++j)
  {
    const Sample expected = model.Evaluate(circle.Direction(z, j));
    worst.Add(samples[j].Radius - expected.Radius);
    worst.Add((samples[j].SurfaceGradient - expected.SurfaceGradient).norm());
  }
  return worst.Value();
}

TEST(LatitudeSynthesis, EqualsSingleEvaluations)
{
  test::Random random(451);
  for (const int degree : {0, 1, 2, 12, 40, 100})
  {
    const RadialModel model(degree, test::RandomCoefficients(random, degree), Vector3::Zero());
    for (const double z : {-0.9, -0.3, 0.0, 0.5, 0.99})
    {
      // Values of about L, gradients of about L^2; angles accumulate L rounding errors.
      EXPECT_LE(Difference(model, 2 * degree + 1, z), 1e-15 * std::pow(degree + 3.0, 2.5))
          << degree << ' ' << z;
    }
  }
}

TEST(LatitudeSynthesis, IsAccurateOnSmallCirclesAboutPoles)
{
  test::Random random(452);
  const RadialModel model(12, test::RandomCoefficients(random, 12), Vector3::Zero());
  for (const double z : {-1.0 + 1e-8, -1.0 + 1.2e-16, 1.0 - 1.2e-16, 1.0 - 1e-8})
  {
    EXPECT_LE(Difference(model, 7, z), 1e-12) << z; // gradients of up to 500
  }
}

TEST(LatitudeSynthesis, HasEquallySpacedUnitDirections)
{
  const LatitudeSynthesis circle(RadialModel(), 8);
  for (std::size_t j = 0; j < 8; ++j)
  {
    const Vector3 u = circle.Direction(0.6, j);
    EXPECT_NEAR(u.norm(), 1.0, 3e-16); // rounding
    EXPECT_EQ(u.z(), 0.6);
    EXPECT_NEAR(
        std::remainder(std::atan2(u.y(), u.x()) - static_cast<double>(j) * M_PI / 4, 2 * M_PI), 0.0,
        1e-15);
  }
}

TEST(LatitudeSynthesis, CirclesAreIndependent)
{
  test::Random random(453);
  const RadialModel model = test::RandomOrgan(random, 9);
  LatitudeSynthesis circle(model, 5);
  const std::vector<Sample> first = circle.Evaluate(0.25);
  circle.Evaluate(-0.75);
  const std::vector<Sample>& again = circle.Evaluate(0.25);
  for (std::size_t j = 0; j < first.size(); ++j)
  {
    EXPECT_EQ(first[j].Radius, again[j].Radius);
    EXPECT_EQ(first[j].SurfaceGradient, again[j].SurfaceGradient);
  }
}

TEST(LatitudeSynthesis, IsAccurateAtDegree1000)
{
  test::Random random(454);
  const RadialModel model(1000, test::RandomCoefficients(random, 1000, 1.0), Vector3::Zero());
  for (const double z : {0.999, 0.1})
  {
    // Radii of about 3, gradients of about 1000; both sides sum 500,000 terms in their own order.
    EXPECT_LE(Difference(model, 11, z), 1e-9) << z;
  }
}
} // namespace
} // namespace palpate::latitude_synthesis_test
