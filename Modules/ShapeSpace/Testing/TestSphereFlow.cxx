#include "SphereFlow.h"

#include "IcosahedronDirections.h"
#include "RandomShapes.h"
#include "SphereMapQuality.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace palpate::sphere_flow_test
{
namespace
{
// Normal coefficients, as long as a step may be.
SphereFlow RandomFlow(test::Random& random, int degree, int steps)
{
  std::normal_distribution<double> normal;
  SphereFlow flow(degree);
  const IcosahedronDirections sphere(12);
  for (int step = 0; step < steps; ++step)
  {
    SphereFlow::Field field(3, (degree + 1) * (degree + 1));
    field = SphereFlow::Field::NullaryExpr(3, field.cols(), [&] { return normal(random); });
    double longest = 0.0;
    for (const Vector3& tangent : flow.TangentsOf(field, sphere.Directions()))
    {
      longest = std::max(longest, tangent.norm());
    }
    flow.Add(flow.LongestStep() / longest * field);
  }
  return flow;
}

TEST(SphereFlow, LongestStepsNeitherFoldNorTearTheSphere)
{
  test::Random random(5);
  const IcosahedronDirections sphere(48);
  for (const int degree : {0, 1, 2, 4, 7})
  {
    for (int trial = 0; trial < 8; ++trial)
    {
      std::vector<Vector3> directions = sphere.Directions();
      RandomFlow(random, degree, 1).Map(directions);
      EXPECT_TRUE(IsBijective(sphere.Triangles(), directions)) << degree;
    }
  }
}

TEST(SphereFlow, StepsFollowEachOther)
{
  test::Random random(6);
  const SphereFlow flow = RandomFlow(random, 3, 1);
  std::vector<Vector3> direction{test::RandomDirection(random)};
  SphereFlow::Field field = SphereFlow::Field::Zero(3, 16);
  field(0, 0) = 0.1;
  SphereFlow both = flow;
  both.Add(field);
  std::vector<Vector3> together = direction;
  both.Map(together);
  flow.Map(direction);
  SphereFlow::Move(flow.TangentsOf(field, direction), 1.0, direction);
  EXPECT_EQ(together.front(), direction.front());
  EXPECT_NEAR(together.front().norm(), 1.0, 1e-15);
}

TEST(SphereFlow, ShortenedToNothingIsTheIdentity)
{
  test::Random random(7);
  SphereFlow flow = RandomFlow(random, 4, 5);
  flow.Shorten(0.0);
  const std::vector<Vector3> directions = test::RandomDirections(random, 20);
  std::vector<Vector3> moved = directions;
  flow.Map(moved);
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    EXPECT_LT((moved[i] - directions[i]).norm(), 1e-15);
  }
}
} // namespace
} // namespace palpate::sphere_flow_test
