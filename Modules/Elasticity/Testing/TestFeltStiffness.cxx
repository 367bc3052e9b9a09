#include "ElasticCases.h"
#include "ElasticForce.h"
#include "FeltStiffness.h"
#include "ForcePerception.h"

#include <gtest/gtest.h>

namespace palpate::felt_stiffness_test
{
namespace
{
ComplianceMaps MapsOf(const test::ElasticCase& organ, int degree)
{
  ComplianceMaps maps;
  const Status status =
      ComplianceMaps::Fit(organ.Model, organ.Solid, organ.Reduced, {degree, 0.0}, {}, maps);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return maps;
}

TEST(FeltStiffness, LesionIsHarderAndTheOtherSideIsNot)
{
  test::ElasticCase organ;
  organ.Model = test::SphereModel();
  organ.Solid.Tissue.AddInclusion(
      test::BallFraction(organ.Model.PointWorld(Vector3::UnitY()) - 8.0 * Vector3::UnitY(), 6.0),
      0.2);
  organ.Build(8, 8);
  const auto felt =
      FeltStiffness::Of(organ.Model, MapsOf(organ, 16), 8.0, {Vector3::UnitY(), -Vector3::UnitY()});
  EXPECT_GT(felt.Noticed[0], 1.0);
  EXPECT_LT(std::abs(felt.Noticed[1]), 1.0);
  EXPECT_EQ(felt.Most, std::max(felt.Most, felt.Forces[0]));
}

TEST(FeltStiffness, ForceIsThatOfTheServoAtTheDepthThatIsStated)
{
  const test::ElasticCase& organ = test::SphereCase(0.0);
  const ComplianceMaps maps = MapsOf(organ, 8);
  const Vector3 direction = Vector3(1.0, 1.0, 0.5).normalized();
  const auto felt = FeltStiffness::Of(organ.Model, maps, 8.0, {direction});
  EXPECT_EQ(felt.Depth, 2.0);
  const auto servo =
      ElasticForce::Of(ComplianceAtlas(maps), organ.Model, direction, felt.Depth, 8.0);
  EXPECT_EQ(felt.Forces[0], servo.ForceWorld.norm());
  EXPECT_EQ(felt.Noticed[0], ForcePerception::Contrast(felt.Forces[0], felt.Median));
  // One tissue all round: within the mesh's unevenness.
  EXPECT_NEAR(felt.Least, felt.Most, 0.01 * felt.Most);
}

TEST(FeltStiffness, IsNotSaidWhereTheBallDoesNotFit)
{
  test::ElasticCase organ;
  organ.Model = test::HollowModel();
  organ.Build(8, 8);
  const auto felt = FeltStiffness::Of(organ.Model, MapsOf(organ, 12), 8.0,
                                      {test::HollowDirection(), -test::HollowDirection()});
  EXPECT_TRUE(std::isnan(felt.Forces[0]));
  EXPECT_TRUE(std::isnan(felt.Noticed[0]));
  EXPECT_FALSE(std::isnan(felt.Forces[1]));
}
} // namespace
} // namespace palpate::felt_stiffness_test
