#include "ClosestPointSearch.h"
#include "ElasticCases.h"
#include "ElasticForce.h"

#include <gtest/gtest.h>

#include <memory>

namespace palpate::elastic_force_test
{
namespace
{
// An organ with a lesion beside its surface, and a ball that touches it.
struct TouchedOrgan
{
  explicit TouchedOrgan(unsigned seed)
  {
    std::mt19937_64 random(seed);
    this->Organ.Model = test::RandomModel(random, 4, 0.02);
    const Vector3 direction = test::RandomDirection(random);
    this->Lesion = direction;
    this->Organ.Solid.Tissue.AddInclusion(
        test::BallFraction(this->Organ.Model.PointWorld(direction) - 9.0 * direction, 6.0), 0.1);
    this->Organ.Build(8, 8);
    ComplianceMaps maps;
    const Status status = ComplianceMaps::Fit(this->Organ.Model, this->Organ.Solid,
                                              this->Organ.Reduced, {16, 0.0}, {}, maps);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    this->Atlas = std::make_unique<ComplianceAtlas>(maps);
    this->Search = std::make_unique<ClosestPointSearch>(
        std::make_shared<const RadialModel>(this->Organ.Model));
  }

  // Of a ball, whose centre is at a place.
  ElasticForce ForceAt(const Vector3& centerWorld, double ball) const
  {
    const ClosestPoint foot = this->Search->Nearest(centerWorld);
    return ElasticForce::Of(*this->Atlas, this->Organ.Model, foot.Direction,
                            ball - foot.SignedDistance, ball);
  }
  Vector3 CenterAbove(const Vector3& direction, double ball, double depth) const
  {
    return this->Organ.Model.PointWorld(direction) +
           (ball - depth) * this->Organ.Model.Normal(direction);
  }

  test::ElasticCase Organ;
  Vector3 Lesion;
  std::unique_ptr<ComplianceAtlas> Atlas;
  std::unique_ptr<ClosestPointSearch> Search;
};

const TouchedOrgan& Organ()
{
  static const TouchedOrgan organ(23);
  return organ;
}

TEST(ElasticForce, IsMinusTheSlopeOfTheEnergy)
{
  std::mt19937_64 random(29);
  std::uniform_real_distribution<double> depths(0.2, 5.0);
  const double step = 1e-4;
  for (const double ball : {4.0, 8.0})
  {
    for (int i = 0; i < 60; ++i)
    {
      const Vector3 place =
          (Organ().Lesion + (i % 2 == 0 ? 0.4 : 2.0) * test::RandomDirection(random)).normalized();
      const Vector3 center = Organ().CenterAbove(place, ball, depths(random));
      const ElasticForce force = Organ().ForceAt(center, ball);
      Vector3 slope;
      for (int axis = 0; axis < 3; ++axis)
      {
        const Vector3 aside = step * Vector3::Unit(axis);
        slope[axis] = (Organ().ForceAt(center + aside, ball).Energy -
                       Organ().ForceAt(center - aside, ball).Energy) /
                      (2.0 * step);
      }
      // Differences are of second order in the step; the nearest point is exact to 1e-9 mm.
      EXPECT_LE((force.ForceWorld + slope).norm(), 2e-5 * force.ForceWorld.norm())
          << ball << " " << i;
    }
  }
}

TEST(ElasticForce, ClosedPathsTakeNoWork)
{
  std::mt19937_64 random(31);
  const double ball = 8.0;
  for (int loop = 0; loop < 6; ++loop)
  {
    const Vector3 first = Organ().Lesion.unitOrthogonal();
    const Vector3 second = Organ().Lesion.cross(first);
    const double size = 0.2 + 0.06 * loop; // rad
    constexpr int Steps = 400;
    double work = 0.0;
    double least = 1e9;
    double most = 0.0;
    Vector3 lastPlace = Vector3::Zero();
    Vector3 lastForce = Vector3::Zero();
    for (int i = 0; i <= Steps; ++i)
    {
      const double angle = 2.0 * Pi * (i % Steps) / Steps;
      const Vector3 direction = (Organ().Lesion + size * (1.0 + std::cos(angle)) * first +
                                 size * std::sin(angle) * second)
                                    .normalized();
      const Vector3 place = Organ().CenterAbove(direction, ball, 2.0 + std::sin(2.0 * angle));
      const ElasticForce force = Organ().ForceAt(place, ball);
      least = std::min(least, force.Energy);
      most = std::max(most, force.Energy);
      if (i > 0)
      {
        work += 0.5 * (force.ForceWorld + lastForce).dot(place - lastPlace);
      }
      lastPlace = place;
      lastForce = force.ForceWorld;
    }
    EXPECT_LE(std::abs(work), 1e-3 * (most - least)) << loop;
  }
}

TEST(ElasticForce, PushesAlongTheNormalOfASphere)
{
  const test::ElasticCase& sphere = test::SphereCase(0.0);
  ComplianceMaps maps;
  ASSERT_TRUE(
      ComplianceMaps::Fit(sphere.Model, sphere.Solid, sphere.Reduced, {4, 0.0}, {}, maps).IsOk());
  const ComplianceAtlas atlas(maps);
  std::mt19937_64 random(37);
  for (int i = 0; i < 20; ++i)
  {
    const Vector3 d = test::RandomDirection(random);
    const ElasticForce force = ElasticForce::Of(atlas, sphere.Model, d, 2.0, 8.0);
    // What is left of the grid of elements in the compliance.
    EXPECT_LE((force.ForceWorld - d.dot(force.ForceWorld) * d).norm(),
              1e-3 * force.ForceWorld.norm());
    EXPECT_TRUE(force.IsValid);
  }
}

TEST(ElasticForce, IsStrongerOverALesion)
{
  const ElasticForce over = Organ().ForceAt(Organ().CenterAbove(Organ().Lesion, 8.0, 2.0), 8.0);
  const ElasticForce away = Organ().ForceAt(Organ().CenterAbove(-Organ().Lesion, 8.0, 2.0), 8.0);
  EXPECT_GT(over.ForceWorld.norm(), 1.1 * away.ForceWorld.norm());
}

TEST(ElasticForce, SaysWhereLinearElasticityEnds)
{
  const auto isValid = [](double ball, double depth)
  { return Organ().ForceAt(Organ().CenterAbove(Organ().Lesion, ball, depth), ball).IsValid; };
  EXPECT_TRUE(isValid(8.0, 3.9));
  EXPECT_FALSE(isValid(8.0, 4.1));
  EXPECT_TRUE(isValid(4.0, 1.9));
  EXPECT_FALSE(isValid(4.0, 2.1));
}

// There the nearest point jumps; the force keeps its size and is said to be invalid.
TEST(ElasticForce, StaysBoundedWhereTheBallDoesNotFit)
{
  test::ElasticCase organ;
  organ.Model = test::HollowModel();
  ASSERT_NO_FATAL_FAILURE(organ.Build(6, 6));
  ComplianceMaps maps;
  ASSERT_TRUE(
      ComplianceMaps::Fit(organ.Model, organ.Solid, organ.Reduced, {12, 0.0}, {}, maps).IsOk());
  const ComplianceAtlas atlas(maps);
  std::mt19937_64 random(59);
  int invalid = 0;
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 d = (test::HollowDirection() + 0.4 * test::RandomDirection(random)).normalized();
    const ElasticForce force = ElasticForce::Of(atlas, organ.Model, d, 2.0, 8.0);
    const double push = force.ForceWorld.dot(organ.Model.Normal(d));
    EXPECT_GT(push, 0.0);
    EXPECT_LE(force.ForceWorld.norm(), 1.12 * push);
    EXPECT_LT(push, 2.0);
    invalid += force.IsValid ? 0 : 1;
  }
  EXPECT_GT(invalid, 10);
  // Also where the nearest point is unique and the depth half the ball's radius.
  const Vector3 bottom = test::HollowDirection();
  const double fitting = -0.9 / atlas.At(bottom).MeanCurvature;
  const auto isValid = [&](double ball)
  { return ElasticForce::Of(atlas, organ.Model, bottom, 0.5 * ball, ball).IsValid; };
  EXPECT_TRUE(isValid(0.4 * fitting));
  EXPECT_FALSE(isValid(1.05 * fitting));
}

TEST(ElasticForce, IsZeroWithoutContact)
{
  const ElasticForce force = Organ().ForceAt(Organ().CenterAbove(Organ().Lesion, 8.0, -0.1), 8.0);
  EXPECT_EQ(force.ForceWorld.norm(), 0.0);
  EXPECT_EQ(force.Energy, 0.0);
}
} // namespace
} // namespace palpate::elastic_force_test
