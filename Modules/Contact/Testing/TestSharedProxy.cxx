#include "ClosestPointSearch.h"
#include "SharedToolCases.h"
#include "TurnBetween.h"

#include <algorithm>

namespace palpate::shared_proxy_test
{
namespace
{
constexpr double BallRadius = test::TouchedRadius;
constexpr double ToolRadius = 2.0; // mm
// mm. A tangent plane stands for the surface over a micrometre, in which it turns by 1e-4.
constexpr double PlaneError = 2e-4;

TEST(SharedProxy, CapsuleAcrossABallGivesTheClosedForm)
{
  const Eigen::Quaterniond lying(Eigen::AngleAxisd(0.5 * EIGEN_PI, Vector3::UnitY()));
  for (const test::TouchedBall& kind : test::TouchedBalls())
  {
    SCOPED_TRACE(kind.Name);
    test::SharedTool tool(ToolShape::Capsule(ToolRadius, 10.0, 400));
    tool.Among(*kind.Model);
    tool.Begin({kind.Center + Vector3(0.0, 0.0, BallRadius + 6.0), lying});
    const ToolPose hand{kind.Center + Vector3(0.0, 0.0, BallRadius + ToolRadius - 1.0), lying};
    const Contact& share = tool.Settle(hand);
    EXPECT_TRUE(share.IsTouching);
    EXPECT_LE((share.ProxyWorld - hand.PositionWorld - Vector3::UnitZ()).norm(), kind.Error);
    EXPECT_LE((share.NormalWorld - Vector3::UnitZ()).norm(), kind.Error);
    EXPECT_LE((share.FootWorld - kind.Center - BallRadius * Vector3::UnitZ()).norm(),
              kind.Error + 0.2)
        << "along the ball it may be anywhere within its own error";
    EXPECT_LE(share.Turn.norm(), 10.0 * kind.Error) << "it is symmetric";
  }
}

TEST(SharedProxy, OneBallIsASphere)
{
  test::Random random(12);
  const RadialModel organ = test::RandomOrgan(random, 8);
  const auto model = test::RadialContact(organ);
  const auto tracker = test::TrackerOf(*model, ToolShape::Sphere(ToolRadius));
  test::SharedTool tool(ToolShape::Capsule(ToolRadius, 0.0, 26));
  tool.Among(*model);
  test::WanderingDirection direction(random);
  const auto place = [&](double depth)
  {
    const Vector3 u = direction.Next(0.01);
    return test::At(organ.PointWorld(u) + (ToolRadius - depth) * u);
  };
  tool.Begin(place(-10.0));
  tracker->Follow(tool.Place());
  int touches = 0;
  for (int tick = 0; tick < 2000; ++tick)
  {
    const ToolPose hand = place(1.0);
    const Contact& share = tool.Settle(hand);
    const Contact& sphere = tracker->Follow(hand);
    touches += sphere.IsTouching ? 1 : 0;
    ASSERT_EQ(share.IsTouching, sphere.IsTouching) << tick;
    ASSERT_LE((share.ProxyWorld - sphere.ProxyWorld).norm(), PlaneError) << tick;
  }
  EXPECT_EQ(touches, 2000);
}

TEST(SharedProxy, TwoStructuresHoldAToolByTheirShares)
{
  constexpr double Aside = 16.0; // mm, of each ball's centre
  const auto left = test::RadialContact(test::Sphere(BallRadius, Vector3(-Aside, 0.0, 0.0)));
  const auto right = test::RadialContact(test::Sphere(BallRadius, Vector3(Aside, 0.0, 0.0)));
  test::SharedTool tool(ToolShape::Capsule(ToolRadius, 0.0, 26));
  tool.Among(*left);
  tool.Among(*right);
  tool.Begin(test::At({0.0, 0.0, 20.0}));
  const Vector3 hand(0.0, 0.0, 3.0);
  tool.Settle(test::At(hand));
  const double reach = BallRadius + ToolRadius;
  const double height = std::sqrt(reach * reach - Aside * Aside);
  EXPECT_LE((tool.Place().PositionWorld - Vector3(0.0, 0.0, height)).norm(), 1e-5);
  // Each holds half of the height, and pushes aside against the other.
  const Vector3 half = 0.5 * (height - hand.z()) * Vector3(Aside / height, 0.0, 1.0);
  EXPECT_LE((tool.ShareOf(0).ProxyWorld - hand - half).norm(), PlaneError);
  EXPECT_LE((tool.ShareOf(1).ProxyWorld - hand - Vector3(-half.x(), 0.0, half.z())).norm(),
            PlaneError);
}

// The hand has turned by more than a tool that touches turns in a tick: until the proxy has
// arrived, the whole is what couples both, or a hand would gain energy from planes that it has long
// left.
TEST(SharedProxy, SharesAddUpToTheCouplingWhileTheToolTips)
{
  const ToolShape shape = ToolShape::Capsule(ToolRadius, 40.0, 200);
  const double length = shape.Skeleton()->Gyration();
  test::SharedTool tool(shape);
  tool.Among(*test::FacetContact(test::BoxMesh({10.0, 10.0, 10.0})));
  const RadialModel ball(0, {BallRadius * std::sqrt(4.0 * EIGEN_PI)}, {-12.0, 0.0, -4.2});
  tool.Among(*test::RadialContact(ball)); // a little higher than the box
  const Eigen::Quaterniond lying(Eigen::AngleAxisd(0.5 * EIGEN_PI, Vector3::UnitY()));
  ToolPose hand{{7.0, 0.0, 10.0 + ToolRadius + 3.0}, lying};
  tool.Begin(hand);
  hand.PositionWorld.z() -= 4.0;
  tool.Settle(hand);
  int behind = 0;
  for (int tick = 0; tick < 200; ++tick)
  {
    // It tips over the edge, and then comes back.
    const double angle = tick < 100 ? 0.6 : -0.3;
    hand.Orientation = Eigen::AngleAxisd(angle, Vector3::UnitY()) * lying;
    tool.Follow(hand);
    const Contact& one = tool.ShareOf(0);
    const Contact& other = tool.ShareOf(1);
    ASSERT_TRUE(one.IsTouching || other.IsTouching) << tick;
    behind += one.IsBehind ? 1 : 0;
    const Vector3 shift = one.ProxyWorld + other.ProxyWorld - 2.0 * hand.PositionWorld;
    const Vector3 turn = TurnBetween(hand.Orientation, tool.Place().Orientation);
    // A tool that arrives may yet move by less than 5 um.
    ASSERT_LE((shift - (tool.Place().PositionWorld - hand.PositionWorld)).norm(), 0.005) << tick;
    ASSERT_LE((one.Turn + other.Turn - length * length * turn).norm(), 0.005 * length) << tick;
  }
  EXPECT_GT(behind, 20);
}

TEST(SharedProxy, StructureAroundTheToolIsPassedUntilItHasLeft)
{
  for (const test::TouchedBall& kind : test::TouchedBalls())
  {
    SCOPED_TRACE(kind.Name);
    test::SharedTool tool(ToolShape::Capsule(ToolRadius, 6.0, 200));
    tool.Among(*kind.Model);
    tool.Begin(test::At(kind.Center));
    EXPECT_TRUE(tool.Passes(0));
    EXPECT_FALSE(tool.Settle(test::At(kind.Center + Vector3(0.0, 3.0, 0.0))).IsTouching);
    EXPECT_FALSE(tool.Settle(test::At(kind.Center + Vector3(0.0, 30.0, 0.0))).IsTouching);
    tool.Follow(test::At(kind.Center + Vector3(0.0, 30.0, 0.0)));
    EXPECT_FALSE(tool.Passes(0));
    EXPECT_TRUE(tool.Settle(test::At(kind.Center)).IsTouching) << "it is outside now";
  }
}

TEST(SharedProxy, EntersNoOrganHoweverTheHandMoves)
{
  test::Random random(99);
  std::uniform_real_distribution<double> any(-30.0, 30.0);
  const RadialModel organ = test::RandomOrgan(random, 10);
  const ClosestPointSearch search(test::Shared(organ));
  const ToolShape shape = ToolShape::Capsule(ToolRadius, 12.0, 200);
  test::SharedTool tool(shape);
  tool.Among(*test::RadialContact(organ));
  tool.Begin(test::At(organ.CenterWorld() + Vector3(0.0, 0.0, 60.0)));
  double deepest = 0.0;
  for (int jump = 0; jump < 300; ++jump)
  {
    const ToolPose hand{
        organ.CenterWorld() + Vector3(any(random), any(random), any(random)),
        Eigen::Quaterniond(Eigen::AngleAxisd(any(random), test::RandomDirection(random)))};
    for (int held = 0; held < 5; ++held)
    {
      tool.Follow(hand);
      for (const ToolSkeleton::Ball& ball : shape.Skeleton()->Balls())
      {
        const Vector3 center = tool.Place().PositionWorld + tool.Place().Orientation * ball.Center;
        deepest = std::max(deepest, ball.Radius - search.Nearest(center).SignedDistance);
      }
    }
  }
  EXPECT_LT(deepest, 0.1) << "mm: a wall may be unknown for Skin, and curves within a stride";
}
} // namespace
} // namespace palpate::shared_proxy_test
