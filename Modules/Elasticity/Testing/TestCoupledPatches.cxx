#include "CoupledPatches.h"
#include "ElasticCases.h"

#include <gtest/gtest.h>

namespace palpate::coupled_patches_test
{
namespace
{
using Wall = CoupledPatches::Wall;

constexpr double Ball = 8.0; // mm

// An organ with a hollow into which the ball does not fit.
struct Hollow
{
  Hollow()
  {
    this->Organ.Model = test::HollowModel();
    this->Organ.Build(8, 8);
    ComplianceMaps maps;
    const Status status = ComplianceMaps::Fit(this->Organ.Model, this->Organ.Solid,
                                              this->Organ.Reduced, {14, 0.0}, {}, maps);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    this->Atlas = std::make_unique<ComplianceAtlas>(maps);
  }

  test::ElasticCase Organ;
  std::unique_ptr<ComplianceAtlas> Atlas;
};

const Hollow& TheHollow()
{
  static const Hollow hollow;
  return hollow;
}

ElasticForce Of(const std::vector<Wall>& walls, double ball = Ball)
{
  return CoupledPatches::Of(*TheHollow().Atlas, TheHollow().Organ.Model, walls.data(), walls.size(),
                            ball);
}

TEST(CoupledPatches, OneWallPushesAsOnePatch)
{
  const Vector3 d = -test::HollowDirection();
  const ElasticForce one =
      ElasticForce::Of(*TheHollow().Atlas, TheHollow().Organ.Model, d, 2.0, Ball);
  const ElasticForce coupled = Of({{d, 2.0}});
  const Vector3 normal = TheHollow().Organ.Model.Normal(d);
  EXPECT_NEAR(coupled.ForceWorld.dot(normal), one.ForceWorld.dot(normal), 1e-12);
  EXPECT_EQ(coupled.Energy, one.Energy);
  EXPECT_EQ(coupled.PatchRadius, one.PatchRadius);
}

// However shallow the ball is, so that nothing else is at its limit.
TEST(CoupledPatches, AreInvalidWhereTheHollowIsTooNarrow)
{
  const Vector3 bottom = test::HollowDirection();
  const double fitting = -0.9 / TheHollow().Atlas->At(bottom).MeanCurvature;
  EXPECT_TRUE(Of({{bottom, 0.001}}, 0.99 * fitting).IsValid);
  EXPECT_FALSE(Of({{bottom, 0.001}}, 1.01 * fitting).IsValid);
}

TEST(CoupledPatches, DoesNotDependOnTheOrder)
{
  const Vector3 d = -test::HollowDirection();
  const Vector3 e = (d + 0.4 * d.unitOrthogonal()).normalized();
  const ElasticForce first = Of({{d, 2.0}, {e, 1.5}});
  const ElasticForce second = Of({{e, 1.5}, {d, 2.0}});
  EXPECT_LE((first.ForceWorld - second.ForceWorld).norm(), 1e-12);
}

// Each wall's, since those of two that face each other nearly cancel.
TEST(CoupledPatches, WallsThatFaceEachOtherKeepTheirForces)
{
  const Vector3 d = test::HollowDirection().unitOrthogonal();
  const Hollow& hollow = TheHollow();
  const std::vector<Wall> walls{{d, 1.0}, {-d, 1.0}};
  std::array<PressedPlace, CoupledPatches::MostWalls> places{};
  CoupledPatches::Of(*hollow.Atlas, hollow.Organ.Model, walls.data(), walls.size(), Ball, {},
                     places.data());
  for (std::size_t i = 0; i < walls.size(); ++i)
  {
    const double alone = Of({walls[i]}).ForceWorld.norm();
    // Their normals differ a little from their directions.
    EXPECT_NEAR(places[i].Force, alone, 0.005 * alone) << i;
  }
}

// One patch that is counted twice: the bumps' sizes differ from those whose coupling is taken.
TEST(CoupledPatches, PatchesThatMeetAreOne)
{
  const Vector3 d = -test::HollowDirection();
  const Vector3 beside = (d + 0.002 * d.unitOrthogonal()).normalized();
  for (const double depth : {1.0, 2.0, 4.0})
  {
    const double one = Of({{d, depth}}).ForceWorld.norm();
    const double two = Of({{d, depth}, {beside, depth}}).ForceWorld.norm();
    EXPECT_NEAR(two, one, 0.3 * one) << depth;
  }
}

TEST(CoupledPatches, AnotherWallNearbyGivesWay)
{
  const Vector3 d = -test::HollowDirection();
  const Vector3 e = (d + 0.3 * d.unitOrthogonal()).normalized();
  const double apart = Of({{d, 2.0}}).ForceWorld.norm() + Of({{e, 2.0}}).ForceWorld.norm();
  const double coupled = Of({{d, 2.0}, {e, 2.0}}).ForceWorld.norm();
  EXPECT_LT(coupled, 0.9 * apart);
  EXPECT_GT(coupled, 0.5 * apart);
}

TEST(CoupledPatches, ForceIsMinusTheSlopeOfTheEnergy)
{
  std::mt19937_64 random(61);
  std::uniform_real_distribution<double> part(0.5, 3.0);
  const double step = 1e-4;
  for (int i = 0; i < 30; ++i)
  {
    // Three walls of a bowl, and the ball's motion into them.
    std::vector<Wall> walls;
    std::vector<Vector3> normals;
    for (int wall = 0; wall < 3; ++wall)
    {
      const Vector3 d =
          (-test::HollowDirection() + 0.5 * test::RandomDirection(random)).normalized();
      walls.push_back({d, part(random)});
      normals.push_back(TheHollow().Organ.Model.Normal(d));
    }
    const auto energyAt = [&](const Vector3& moved)
    {
      std::vector<Wall> pressed = walls;
      for (std::size_t w = 0; w < pressed.size(); ++w)
      {
        pressed[w].Depth -= moved.dot(normals[w]);
      }
      return Of(pressed).Energy;
    };
    const ElasticForce force = Of(walls);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3 aside = step * Vector3::Unit(axis);
      const double slope = (energyAt(aside) - energyAt(-aside)) / (2.0 * step);
      EXPECT_NEAR(force.ForceWorld[axis], -slope, 1e-5 * force.ForceWorld.norm()) << i;
    }
  }
}
} // namespace
} // namespace palpate::coupled_patches_test
