#include "SharedToolCases.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace palpate::tools_of_balls_test
{
namespace
{
// How far a tool reaches downwards from its origin, whose axis is tilted by an angle from the
// vertical; mm.
using Reach = std::function<double(double)>;

struct Kind
{
  const char* Name;
  ToolShape Shape;
  Reach Down;
  double Error; // mm
};

// Points of a box's surface a millimetre apart, and their normals.
ToolShape BoxTool(const Vector3& half)
{
  std::vector<Vector3> points;
  std::vector<Vector3> inward;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (const double side : {-1.0, 1.0})
    {
      for (double x = 0.5 - half[u]; x < half[u]; x += 1.0)
      {
        for (double y = 0.5 - half[v]; y < half[v]; y += 1.0)
        {
          Vector3 point;
          point[axis] = side * half[axis];
          point[u] = x;
          point[v] = y;
          points.push_back(point);
          inward.emplace_back(-side * Vector3::Unit(axis));
        }
      }
    }
  }
  return ToolShape::FromSurfacePoints(points, inward);
}

// A box's points end half a millimetre before its edges, and have balls of a quarter.
double BoxReach(const Vector3& half, double tilt)
{
  constexpr double Round = 0.25;
  const Vector3 inner = half.array() - Round;
  const double wide = half[1] - 0.5;
  const double high = half[2] - 0.5;
  const double up = std::abs(std::cos(tilt));
  const double aside = std::abs(std::sin(tilt));
  return Round + std::max(inner[2] * up + wide * aside, high * up + inner[1] * aside);
}

std::vector<Kind> Kinds()
{
  const Vector3 box(6.0, 4.0, 3.0);
  return {
      {"capsule", ToolShape::Capsule(2.0, 10.0, 26),
       [](double tilt) { return 2.0 + 5.0 * std::abs(std::cos(tilt)); }, 1e-6},
      {"drill", ToolShape::Drill(2.5, 1.0, 20.0, 100),
       [](double tilt) { return std::max(2.5, 1.0 - 20.0 * std::cos(tilt)); }, 1e-6},
      {"needle", ToolShape::Drill(0.3, 0.3, 40.0, 100),
       [](double tilt) { return 0.3 + std::max(0.0, -40.0 * std::cos(tilt)); }, 1e-6},
      {"cylinder", ToolShape::Cylinder(3.0, 12.0, 200),
       [](double tilt)
       { return 0.3 + 5.7 * std::abs(std::cos(tilt)) + 2.7 * std::abs(std::sin(tilt)); },
       0.02}, // the rims are rings of balls
      {"ellipsoid", ToolShape::Ellipsoid({2.0, 2.0, 6.0}, 200),
       [](double tilt) { return std::hypot(6.0 * std::cos(tilt), 2.0 * std::sin(tilt)); }, 4e-4},
      {"disc", ToolShape::Ellipsoid({5.0, 5.0, 2.0}, 200),
       [](double tilt) { return std::hypot(2.0 * std::cos(tilt), 5.0 * std::sin(tilt)); }, 4e-4},
      {"box", BoxTool(box), [box](double tilt) { return BoxReach(box, tilt); }, 1e-6}};
}

// The tilt of least energy in a row with the hand's, if the tool may not reach below 0.
double TiltAtRest(const Kind& kind, double handHeight, double handTilt, double length)
{
  const auto energy = [&](double tilt)
  {
    const double up = std::max(0.0, kind.Down(tilt) - handHeight);
    return up * up + length * length * (tilt - handTilt) * (tilt - handTilt);
  };
  constexpr double Step = 1e-6; // rad
  double tilt = handTilt;
  for (const double way : {-Step, Step})
  {
    while (energy(tilt + way) < energy(tilt))
    {
      tilt += way;
    }
  }
  return tilt;
}

TEST(ToolsOfBalls, RestOnAHalfSpaceWithTheLeastEnergy)
{
  constexpr double Pressed = 2.0; // mm
  const auto floor = test::FacetContact(test::BoxMesh({200.0, 200.0, 50.0}));
  for (const Kind& kind : Kinds())
  {
    ASSERT_TRUE(kind.Shape.Check().IsOk()) << kind.Name;
    ASSERT_NE(kind.Shape.Skeleton(), nullptr) << kind.Name;
    for (const double tilt : {0.4, 0.9, 1.4, 2.0})
    {
      SCOPED_TRACE(std::string(kind.Name) + " at " + std::to_string(tilt));
      test::SharedTool tool(kind.Shape);
      tool.Among(*floor);
      // About x, so that the axis points up at an angle of `tilt`.
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(tilt, Vector3::UnitX()));
      const double handHeight = kind.Down(tilt) - Pressed;
      const Vector3 above(3.3, -1.7, 50.0); // the floor is at 50 mm
      tool.Begin({above + 60.0 * Vector3::UnitZ(), turn});
      const ToolPose hand{above + handHeight * Vector3::UnitZ(), turn};
      const Contact& share = tool.Settle(hand);
      const double length = kind.Shape.Skeleton()->Gyration();
      const double rest = TiltAtRest(kind, handHeight, tilt, length);
      const double up = kind.Down(rest) - handHeight;
      EXPECT_NEAR((share.ProxyWorld - hand.PositionWorld).z(), up, kind.Error + 1e-4);
      EXPECT_NEAR(share.Turn.x(), length * length * (rest - tilt),
                  30.0 * kind.Error + 1e-2 * length * length * 1e-2)
          << "by " << rest - tilt;
      EXPECT_LE(std::hypot(share.Turn.y(), share.Turn.z()), 30.0 * kind.Error + 1e-6);
    }
  }
}

TEST(ToolsOfBalls, OnlyTheBallOfADrillCuts)
{
  const auto floor = test::FacetContact(test::BoxMesh({200.0, 200.0, 50.0}));
  for (const bool isUpright : {true, false})
  {
    test::SharedTool tool(ToolShape::Drill(2.5, 1.0, 20.0, 100));
    tool.Among(*floor);
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(isUpright ? 0.0 : EIGEN_PI - 0.1, Vector3::UnitX()));
    tool.Begin({Vector3(0.0, 0.0, 100.0), turn});
    const double reach = isUpright ? 2.5 : 1.0 + 20.0 * std::cos(0.1);
    ASSERT_TRUE(tool.Settle({Vector3(0.0, 0.0, 50.0 + reach - 1.0), turn}).IsTouching);
    EXPECT_NEAR(tool.CutOffset(0).z(), isUpright ? 1.0 : 0.0, 1e-9);
  }
}

// Deepest place of a tool in the ball, mm.
double DepthIn(const test::TouchedBall& ball, const ToolShape& shape, const ToolPose& pose)
{
  double deepest = 0.0;
  for (const ToolSkeleton::Ball& part : shape.Skeleton()->Balls())
  {
    const Vector3 center = pose.PositionWorld + pose.Orientation * part.Center;
    deepest = std::max(deepest, test::TouchedRadius + part.Radius - (center - ball.Center).norm());
  }
  return deepest;
}

TEST(ToolsOfBalls, EnterNothingHoweverTheHandMoves)
{
  std::vector<ToolShape> shapes{
      ToolShape::Capsule(2.0, 10.0, 26), ToolShape::Drill(2.5, 1.0, 20.0, 100),
      ToolShape::Cylinder(3.0, 12.0, 200), ToolShape::Ellipsoid({2.0, 3.0, 6.0}, 200),
      BoxTool({6.0, 4.0, 3.0})};
  for (const test::TouchedBall& ball : test::TouchedBalls())
  {
    for (std::size_t n = 0; n < shapes.size(); ++n)
    {
      SCOPED_TRACE(std::string(ball.Name) + " " + std::to_string(n));
      test::Random random(17);
      std::uniform_real_distribution<double> any(-25.0, 25.0);
      test::SharedTool tool(shapes[n]);
      tool.Among(*ball.Model);
      tool.Begin(test::At(ball.Center + Vector3(0.0, 0.0, 60.0)));
      double deepest = 0.0;
      for (int jump = 0; jump < 60; ++jump)
      {
        const ToolPose hand{
            ball.Center + Vector3(any(random), any(random), any(random)),
            Eigen::Quaterniond(Eigen::AngleAxisd(any(random), test::RandomDirection(random)))};
        for (int held = 0; held < 5; ++held)
        {
          tool.Follow(hand);
          deepest = std::max(deepest, DepthIn(ball, shapes[n], tool.Place()));
        }
      }
      EXPECT_LT(deepest, 0.1);
    }
  }
}
} // namespace
} // namespace palpate::tools_of_balls_test
