#include "HalfSpaces.h"
#include "SurfacePhantoms.h"
#include "TouchableSurfaceModel.h"
#include "WedgeGroove.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

namespace palpate::wedge_groove_test
{
namespace
{
using Wall = TouchableSurfaceModel::ClosestPoint;

// Where two hollow spheres of 20 mm overlap, with centres 20 mm apart, a ball of 4 mm that touches
// both can move along a circle.
constexpr double Hollow = 20.0;
constexpr double Ball = 4.0;
const std::array<Vector3, 2> Centers{Vector3(-10.0, 0.0, 0.0), Vector3(10.0, 0.0, 0.0)};
const double CircleRadius = std::sqrt(std::pow(Hollow - Ball, 2) - 100.0);

std::array<Wall, 2> WallsAt(const Vector3& place)
{
  std::shared_ptr<const TouchableSurfaceModel> sphere;
  EXPECT_TRUE(TouchableSurfaceModel::Make(test::EllipsoidPhantom(Vector3::Constant(Hollow)), sphere)
                  .IsOk());
  std::array<Wall, 2> walls;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const Vector3 query = sphere->Model().CenterWorld() + (place - Centers[i]);
    walls[i] = sphere->SeenFromOutside(sphere->Search().Nearest(query));
  }
  return walls;
}

// With a goal that is seven times as far behind the walls as they curve.
TEST(WedgeGroove, StepsEndWhereTheSphereIsNearestToItsGoal)
{
  const Vector3 goal(0.0, 8.0 * CircleRadius, 0.0);
  const Vector3 rest(0.0, CircleRadius, 0.0);
  const Vector3 place = CircleRadius * Vector3(0.0, std::cos(0.05), std::sin(0.05));
  const std::array<Wall, 2> walls = WallsAt(place);
  std::array<HalfSpace, 2> planes;
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_NEAR(walls[i].SignedDistance, Ball, 1e-6);
    planes[i] = {walls[i].Normal, walls[i].Normal.dot(place) + Ball - walls[i].SignedDistance};
  }
  const Vector3 held = NearestInHalfSpaces(goal, planes.data(), planes.size()).Point;
  const WedgeGroove groove(walls[0], walls[1], held - goal);
  ASSERT_TRUE(groove.IsKnown());
  const double left = (place - rest).norm();
  EXPECT_GT((held - rest).norm(), 6.0 * left); // steps to the planes' place never come to rest
  EXPECT_LT((place + groove.Newton(held - place) - rest).norm(), 0.1 * left);
}

TEST(WedgeGroove, LeavesStepsAsTheyAreBetweenParallelWalls)
{
  const std::array<Wall, 2> walls = WallsAt(Vector3(0.0, CircleRadius, 0.0));
  const Vector3 step(0.1, 0.2, 0.3);
  const WedgeGroove none(walls[0], walls[0], -walls[0].Normal);
  EXPECT_FALSE(none.IsKnown());
  EXPECT_EQ(none.Newton(step), step);
  EXPECT_EQ(WedgeGroove().Newton(step), step);
}
} // namespace
} // namespace palpate::wedge_groove_test
