#include "ModelCorrection.h"
#include "RandomShapes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::model_correction_test
{
namespace
{
using namespace palpate::test;

constexpr double Radius = 25.0;
const double Constant = Radius * std::sqrt(4.0 * M_PI);

RadialModel Ball()
{
  return {0, {Constant}, Vector3(1.0, 2.0, 3.0)};
}

// Pulls of an organ on two sides.
void PullTwice(SurfaceCorrection& correction)
{
  for (const std::size_t n : {10, 100})
  {
    SurfacePull pull;
    pull.PlaceWorld = correction.Points()[n];
    pull.Displacement = n == 10 ? 4.0 : -3.0;
    pull.Width = 9.0;
    ASSERT_TRUE(correction.Pull(pull).IsOk());
  }
}

TEST(ModelCorrection, RadialModelsMoveAlongTheirRays)
{
  const OrganModel start = Ball();
  SurfaceCorrection correction = StartOfModel(start, 8);
  PullTwice(correction);
  OrganModel corrected;
  ASSERT_TRUE(ModelCorrection::Apply(start, correction, corrected).IsOk());
  const auto& radial = std::get<RadialModel>(corrected);
  EXPECT_EQ(radial.Degree(), ModelCorrection::LeastDegree);
  EXPECT_EQ(radial.CenterWorld(), Vector3(1.0, 2.0, 3.0));
  for (std::size_t n = 0; n < correction.Points().size(); ++n)
  {
    // What degree 20 leaves out of a width of 0.36 of the radius.
    EXPECT_NEAR(radial.Radius(correction.Directions()[n]),
                (correction.PointNow(n) - radial.CenterWorld()).norm(), 0.01);
  }
}

TEST(ModelCorrection, SurfaceModelsMoveAsTheyArePulled)
{
  const OrganModel start = SurfaceModel::FromModel(Ball());
  SurfaceCorrection correction = StartOfModel(start, 8);
  PullTwice(correction);
  OrganModel corrected;
  ASSERT_TRUE(ModelCorrection::Apply(start, correction, corrected).IsOk());
  const auto& surface = std::get<SurfaceModel>(corrected);
  for (std::size_t n = 0; n < correction.Points().size(); ++n)
  {
    EXPECT_LT((surface.Point(correction.Directions()[n]) - correction.PointNow(n)).norm(), 0.01);
  }
}

TEST(ModelCorrection, WithoutPullsAModelStays)
{
  Random random(3);
  std::vector<double> coefficients = RandomCoefficients(random, 24, 2.0);
  coefficients[0] = Constant;
  const OrganModel organ = RadialModel(24, coefficients, Vector3::Zero());
  OrganModel corrected;
  ASSERT_TRUE(ModelCorrection::Apply(organ, StartOfModel(organ, 4), corrected).IsOk());
  EXPECT_EQ(DegreeOf(corrected), 24);
  for (std::size_t n = 0; n < coefficients.size(); ++n)
  {
    EXPECT_NEAR(std::get<RadialModel>(corrected).Coefficients()[n], coefficients[n],
                1e-10); // rounding
  }
}

TEST(ModelCorrection, RefusesARadialModelPushedThroughItsCentre)
{
  const OrganModel start = Ball();
  SurfaceCorrection correction = StartOfModel(start, 8);
  SurfacePull pull;
  pull.PlaceWorld = correction.Points()[0];
  pull.Displacement = -26.0;
  ASSERT_TRUE(correction.Pull(pull).IsOk());
  OrganModel corrected;
  EXPECT_FALSE(ModelCorrection::Apply(start, correction, corrected).IsOk());
}
} // namespace
} // namespace palpate::model_correction_test
