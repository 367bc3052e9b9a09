#include "EdgeField.h"

#include "FeltCases.h"
#include "RandomOrientation.h"

#include <cmath>

namespace palpate::edge_field_test
{
namespace
{
constexpr double Edge = 3.0; // mm, along x

// A step of 400 that is blurred by 1.5 mm.
double Step(const Vector3& place)
{
  return 200.0 * std::tanh((place.x() - Edge) / 1.5);
}

std::shared_ptr<const GuidingGradient> ForceOf(const std::function<double(const Vector3&)>& image,
                                               const Matrix3& turn = Matrix3::Identity())
{
  std::shared_ptr<const GuidingGradient> made;
  const Status status = MakeEdgeForce(
      test::FeltField(test::FeltGrid(40, turn), image, FieldInterpolation::TricubicBSpline), {},
      made);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return made;
}

TEST(EdgeField, PullsTowardsTheEdgeFromBothSides)
{
  const auto force = ForceOf(Step);
  for (const double distance : {1.0, 1.5, 2.0})
  {
    const Vector3 before = force->ForceWorld({Edge - distance, 1.0, -2.0});
    const Vector3 behind = force->ForceWorld({Edge + distance, 1.0, -2.0});
    EXPECT_GT(before.x(), 0.02) << distance;
    EXPECT_LT(behind.x(), -0.02) << distance;
    // The grid is symmetrical about the edge, and the image constant along it.
    EXPECT_NEAR(before.x(), -behind.x(), 1e-3);
    EXPECT_LT(std::hypot(before.y(), before.z()), 1e-6);
  }
  EXPECT_LT(force->ForceWorld({Edge, 1.0, -2.0}).norm(), 1e-3) << "on it";
  EXPECT_LT(force->ForceWorld({Edge - 10.0, 1.0, -2.0}).norm(), 1e-2) << "far from it";
}

TEST(EdgeField, SteepestPlaceHasTheLargestForce)
{
  test::Random random(71);
  for (const double contrast : {1e-3, 1.0, 1e4})
  {
    const auto force = ForceOf([&](const Vector3& place) { return contrast * Step(place); });
    double largest = 0.0;
    std::uniform_real_distribution<double> place(-19.0, 19.0);
    for (int n = 0; n < 20000; ++n)
    {
      largest = std::max(largest,
                         force->ForceWorld({place(random), place(random), place(random)}).norm());
    }
    EXPECT_LE(largest, 0.3);
    EXPECT_GT(largest, 0.2) << "whatever the image's unit is";
  }
}

TEST(EdgeField, ClosedPathsDoNoWork)
{
  test::Random random(72);
  const auto force = ForceOf([](const Vector3& place)
                             { return 100.0 * std::tanh(place.norm() - 7.0 - 0.1 * place.y()); },
                             test::RandomOrientation(random));
  double work = 0.0;
  constexpr int Steps = 20000;
  const auto at = [](int n)
  {
    const double turn = 2.0 * M_PI * n / Steps;
    return Vector3(6.0 * std::cos(turn), 5.0 * std::sin(turn), 3.0 * std::sin(2.0 * turn));
  };
  for (int n = 0; n < Steps; ++n)
  {
    work += force->ForceWorld(0.5 * (at(n) + at(n + 1))).dot(at(n + 1) - at(n));
  }
  EXPECT_LT(std::abs(work), 1e-5) << "the midpoint rule's error";
}

TEST(EdgeField, RefusesAnImageWithoutEdges)
{
  test::Random random(73);
  std::normal_distribution<double> normal;
  std::shared_ptr<const GuidingGradient> noise;
  EXPECT_FALSE(
      MakeEdgeForce(test::FeltField(
                        test::FeltGrid(32), [&](const Vector3&) { return 300.0 + normal(random); },
                        FieldInterpolation::TricubicBSpline),
                    {}, noise)
          .IsOk());
  std::shared_ptr<const GuidingGradient> made;
  const auto constant = test::FeltField(
      test::FeltGrid(12), [](const Vector3&) { return 7.0; }, FieldInterpolation::TricubicBSpline);
  EXPECT_FALSE(MakeEdgeForce(constant, {}, made).IsOk());
  EXPECT_EQ(made, nullptr);
}
} // namespace
} // namespace palpate::edge_field_test
