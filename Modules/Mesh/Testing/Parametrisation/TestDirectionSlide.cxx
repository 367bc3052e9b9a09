#include "DirectionSlide.h"

#include "ClosedMeshes.h"
#include "SphereMapQuality.h"
#include "WorstCase.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::direction_slide_test
{
namespace
{
using test::Random;
using test::WorstCase;

constexpr double LongestStep = 0.15; // rad
constexpr double LeastShare = 0.1;

std::vector<Vector3> RandomSteps(Random& random, const std::vector<Vector3>& directions,
                                 double length)
{
  std::vector<Vector3> steps;
  for (const Vector3& u : directions)
  {
    const Vector3 v = test::RandomDirection(random);
    steps.push_back(length * (v - v.dot(u) * u).normalized());
  }
  return steps;
}

double DeterminantOf(const std::vector<Vector3>& u, const std::array<int, 3>& t)
{
  return u[static_cast<std::size_t>(t[0])].dot(
      u[static_cast<std::size_t>(t[1])].cross(u[static_cast<std::size_t>(t[2])]));
}

TEST(DirectionSlide, ShortStepsFollowTheirGreatCircles)
{
  Random random(1);
  const IndexedMesh mesh = test::SphereMesh(6);
  const std::vector<Vector3> steps = RandomSteps(random, mesh.Points, 0.01);
  std::vector<Vector3> moved = mesh.Points;
  DirectionSlide slide;
  ASSERT_TRUE(SlideDirections(mesh.Triangles, steps, LongestStep, LeastShare, moved, slide).IsOk());
  WorstCase worst;
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    worst.Add(
        (moved[i] - (std::cos(0.01) * mesh.Points[i] + 100.0 * std::sin(0.01) * steps[i])).norm());
  }
  EXPECT_LE(worst.Value(), 1e-14); // rounding
  EXPECT_EQ(slide.Halved, 0);
  EXPECT_EQ(slide.Reverted, 0);
}

TEST(DirectionSlide, NoStepsChangeNothing)
{
  const IndexedMesh mesh = test::SphereMesh(4);
  std::vector<Vector3> moved = mesh.Points;
  DirectionSlide slide;
  const std::vector<Vector3> none(moved.size(), Vector3::Zero());
  ASSERT_TRUE(SlideDirections(mesh.Triangles, none, LongestStep, LeastShare, moved, slide).IsOk());
  EXPECT_EQ(moved, mesh.Points);
}

TEST(DirectionSlide, IgnoresRadialPartsAndShortensLongSteps)
{
  const IndexedMesh mesh = test::SphereMesh(1);
  std::vector<Vector3> steps(mesh.Points.size(), Vector3::Zero());
  const Vector3 u = mesh.Points[4];
  steps[4] = 3.0 * u + 5.0 * u.unitOrthogonal();
  std::vector<Vector3> moved = mesh.Points;
  DirectionSlide slide;
  ASSERT_TRUE(SlideDirections(mesh.Triangles, steps, LongestStep, LeastShare, moved, slide).IsOk());
  EXPECT_NEAR(std::acos(moved[4].dot(u)), LongestStep, 1e-14); // rounding
}

TEST(DirectionSlide, GuardKeepsEveryTriangleAboveItsShare)
{
  Random random(2);
  const IndexedMesh mesh = test::SphereMesh(12);
  std::vector<Vector3> moved = mesh.Points;
  bool hasGuarded = false;
  for (int trial = 0; trial < 20; ++trial)
  {
    // As long as an edge: most steps fold a triangle.
    const std::vector<Vector3> before = moved;
    const std::vector<Vector3> steps = RandomSteps(random, moved, 0.1);
    DirectionSlide slide;
    ASSERT_TRUE(
        SlideDirections(mesh.Triangles, steps, LongestStep, LeastShare, moved, slide).IsOk());
    hasGuarded = hasGuarded || slide.Halved > 0;
    EXPECT_TRUE(IsBijective(mesh.Triangles, moved));
    EXPECT_NE(moved, before);
    for (const std::array<int, 3>& t : mesh.Triangles)
    {
      // Rounding of the two formulas.
      EXPECT_GE(DeterminantOf(moved, t), LeastShare * DeterminantOf(before, t) - 1e-15);
    }
  }
  EXPECT_TRUE(hasGuarded);
}

TEST(DirectionSlide, RevertsAStepThatFoldsAtAnyLength)
{
  // A triangle so thin that its tip must not move towards the opposite edge.
  IndexedMesh mesh = test::SphereMesh(2);
  const std::array<int, 3> t = mesh.Triangles[0];
  const auto at = [&](std::size_t i) -> Vector3&
  { return mesh.Points[static_cast<std::size_t>(t[i])]; };
  const Vector3 foot = (at(1) + at(2)).normalized();
  at(0) = (foot + 1e-4 * (at(0) - foot)).normalized();
  std::vector<Vector3> steps(mesh.Points.size(), Vector3::Zero());
  steps[static_cast<std::size_t>(t[0])] = 1e3 * (foot - at(0));
  std::vector<Vector3> moved = mesh.Points;
  DirectionSlide slide;
  ASSERT_TRUE(SlideDirections(mesh.Triangles, steps, LongestStep, LeastShare, moved, slide).IsOk());
  EXPECT_EQ(moved, mesh.Points);
  EXPECT_EQ(slide.Reverted, 1);
}

TEST(DirectionSlide, RejectsBadStepsAndFoldedMaps)
{
  const IndexedMesh mesh = test::SphereMesh(2);
  std::vector<Vector3> moved = mesh.Points;
  std::vector<Vector3> steps(moved.size(), Vector3::Zero());
  DirectionSlide slide;
  const auto apply = [&]
  { return SlideDirections(mesh.Triangles, steps, LongestStep, LeastShare, moved, slide).IsOk(); };
  steps[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(apply());
  steps.pop_back();
  EXPECT_FALSE(apply());
  EXPECT_EQ(moved, mesh.Points);
  steps.assign(moved.size(), Vector3::Zero());
  moved[5] = -moved[5];
  const std::vector<Vector3> folded = moved;
  EXPECT_FALSE(apply());
  EXPECT_EQ(moved, folded);
}
} // namespace
} // namespace palpate::direction_slide_test
