#include "ClosestPointSearch.h"
#include "CoupledPatches.h"
#include "ElasticCases.h"

#include <gtest/gtest.h>

namespace palpate
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
    this->Search = std::make_unique<ClosestPointSearch>(
        std::make_shared<const SphericalHarmonicModel>(this->Organ.Model));
    this->Aside = test::HollowDirection().unitOrthogonal();
  }

  // Of a ball whose centre is over the hollow's middle at this distance from the organ's centre,
  // moved aside by these two lengths.
  Vector3 Place(double height, double aside, double across) const
  {
    return this->Organ.Model.CenterWorld() + height * test::HollowDirection() +
           aside * this->Aside + across * test::HollowDirection().cross(this->Aside);
  }
  // Both sides of the hollow, continued from where the ball touches each alone.
  std::vector<Wall> WallsAt(const Vector3& center) const
  {
    std::vector<Wall> walls;
    for (const double side : {-1.0, 1.0})
    {
      ClosestPoint foot = this->Search->Nearest(center + side * 2.0 * this->Aside);
      for (const double part : {1.5, 1.0, 0.5, 0.0})
      {
        foot = this->Search->Track(center + part * side * this->Aside, foot);
      }
      if (foot.Converged() && foot.SignedDistance < Ball)
      {
        walls.push_back({foot.Direction, Ball - foot.SignedDistance});
      }
    }
    return walls;
  }
  ElasticForce ForceAt(const Vector3& center) const
  {
    const auto walls = this->WallsAt(center);
    return CoupledPatches::Of(*this->Atlas, this->Organ.Model, walls.data(), walls.size(), Ball);
  }

  test::ElasticCase Organ;
  std::unique_ptr<ComplianceAtlas> Atlas;
  std::unique_ptr<ClosestPointSearch> Search;
  Vector3 Aside;
};

const Hollow& TheHollow()
{
  static const Hollow hollow;
  return hollow;
}

ElasticForce Of(const std::vector<Wall>& walls)
{
  return CoupledPatches::Of(*TheHollow().Atlas, TheHollow().Organ.Model, walls.data(), walls.size(),
                            Ball);
}

TEST(CoupledPatches, OneWallIsTheForceOfOnePatch)
{
  const Vector3 d = -test::HollowDirection();
  const ElasticForce one =
      ElasticForce::Of(*TheHollow().Atlas, TheHollow().Organ.Model, d, 2.0, Ball);
  const ElasticForce coupled = Of({{d, 2.0}});
  EXPECT_EQ(coupled.ForceWorld, one.ForceWorld);
  EXPECT_EQ(coupled.Energy, one.Energy);
  EXPECT_EQ(coupled.PatchRadius, one.PatchRadius);
}

TEST(CoupledPatches, DoesNotDependOnTheOrder)
{
  const Vector3 d = -test::HollowDirection();
  const Vector3 e = (d + 0.4 * d.unitOrthogonal()).normalized();
  const ElasticForce first = Of({{d, 2.0}, {e, 1.5}});
  const ElasticForce second = Of({{e, 1.5}, {d, 2.0}});
  EXPECT_LE((first.ForceWorld - second.ForceWorld).norm(), 1e-12);
}

TEST(CoupledPatches, WallsThatFaceEachOtherAddTheirForces)
{
  const Vector3 d = test::HollowDirection().unitOrthogonal();
  const auto alone = [&](const Vector3& direction) { return Of({{direction, 1.0}}).ForceWorld; };
  // Their normals differ a little from their directions.
  EXPECT_LE((Of({{d, 1.0}, {-d, 1.0}}).ForceWorld - alone(d) - alone(-d)).norm(),
            0.01 * alone(d).norm());
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

TEST(CoupledPatches, ForceIsMinusTheSlopeOfTheEnergyInAHollow)
{
  std::mt19937_64 random(61);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  const double step = 1e-4;
  int pairs = 0;
  for (int i = 0; i < 40; ++i)
  {
    const Vector3 center =
        TheHollow().Place(24.0 + 1.0 * part(random), 0.6 * part(random), 0.6 * part(random));
    if (TheHollow().WallsAt(center).size() < 2)
    {
      continue;
    }
    ++pairs;
    const ElasticForce force = TheHollow().ForceAt(center);
    Vector3 slope;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3 aside = step * Vector3::Unit(axis);
      slope[axis] = (TheHollow().ForceAt(center + aside).Energy -
                     TheHollow().ForceAt(center - aside).Energy) /
                    (2.0 * step);
    }
    // The coupling's change with the softness of the places is left out.
    EXPECT_LE((force.ForceWorld + slope).norm(), 0.01 * force.ForceWorld.norm()) << i;
  }
  EXPECT_GT(pairs, 10);
}
} // namespace
} // namespace palpate
