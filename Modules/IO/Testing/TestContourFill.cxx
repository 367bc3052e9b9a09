#include "ContourFill.h"

#include "MessageOf.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace palpate::contour_fill_test
{
namespace
{
using namespace palpate::test;

constexpr std::int64_t Enough = 1000000;

using Voxels = std::set<std::int64_t>;

Voxels VoxelsOf(const std::vector<SliceContour>& contours, const std::array<int, 3>& size)
{
  Voxels voxels;
  for (const VoxelRun& run : ContourFill("a", size, Enough).Runs(contours))
  {
    for (std::int64_t i = 0; i < run.Count; ++i)
    {
      EXPECT_TRUE(voxels.insert(run.First + i).second);
    }
  }
  return voxels;
}

// By the sum of the angles under which the edges are seen, which is a multiple of a turn.
bool IsInside(const SliceContour& contour, const Eigen::Vector2d& point)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < contour.Points.size(); ++i)
  {
    const Eigen::Vector2d a = contour.Points[i] - point;
    const Eigen::Vector2d b = contour.Points[(i + 1) % contour.Points.size()] - point;
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::lround(sum / (2.0 * 3.14159265358979)) % 2 != 0;
}

SliceContour Square(double low, double high, double slice)
{
  return {slice, {{low, low}, {high, low}, {high, high}, {low, high}}};
}

std::set<std::int64_t> SlicesOf(const std::vector<double>& planes, int slices)
{
  std::vector<SliceContour> contours;
  for (const double plane : planes)
  {
    contours.push_back(Square(0.5, 1.5, plane));
  }
  std::set<std::int64_t> found;
  for (const std::int64_t voxel : VoxelsOf(contours, {3, 3, slices}))
  {
    found.insert(voxel / 9);
  }
  return found;
}

// Polygons that cross themselves, other polygons, and the borders of the grid.
TEST(ContourFill, VoxelsAreInsideOfOddNumberOfTurns)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-3.0, 13.0);
  for (int round = 0; round < 200; ++round)
  {
    std::vector<SliceContour> contours(2);
    for (SliceContour& contour : contours)
    {
      contour.Slice = 1.0;
      for (int i = 0; i < 3 + round % 8; ++i)
      {
        contour.Points.emplace_back(place(random), place(random));
      }
    }
    const Voxels voxels = VoxelsOf(contours, {11, 9, 3});
    for (int j = 0; j < 9; ++j)
    {
      for (int i = 0; i < 11; ++i)
      {
        const bool isInside = IsInside(contours[0], {i, j}) != IsInside(contours[1], {i, j});
        EXPECT_EQ(voxels.count(99 + 11 * j + i) > 0, isInside) << round;
      }
    }
    EXPECT_TRUE(voxels.empty() || (*voxels.begin() >= 99 && *voxels.rbegin() < 198));
  }
}

TEST(ContourFill, AdjacentSquaresShareNoVoxelAndLeaveNone)
{
  const Voxels left = VoxelsOf({{0, {{0, 0}, {2, 0}, {2, 4}, {0, 4}}}}, {4, 4, 1});
  const Voxels right = VoxelsOf({{0, {{2, 0}, {4, 0}, {4, 4}, {2, 4}}}}, {4, 4, 1});
  EXPECT_EQ(left.size() + right.size(), 16u);
  for (const std::int64_t voxel : left)
  {
    EXPECT_EQ(right.count(voxel), 0u);
  }
}

TEST(ContourFill, PlaneStandsForHalfDistanceToItsNeighbours)
{
  using Slices = std::set<std::int64_t>;
  EXPECT_EQ(SlicesOf({4}, 9), (Slices{4}));
  EXPECT_EQ(SlicesOf({3, 4, 5}, 9), (Slices{3, 4, 5}));
  EXPECT_EQ(SlicesOf({2, 4, 6}, 9), (Slices{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(SlicesOf({2.001, 3.999, 6.001}, 9), (Slices{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(SlicesOf({2, 3, 6}, 9), (Slices{2, 3, 6}));
  EXPECT_EQ(SlicesOf({2.3, 3.3}, 9), (Slices{2, 3}));
  EXPECT_EQ(SlicesOf({2, 2.25, 2.5, 2.75, 3}, 9), (Slices{2, 3}));
  EXPECT_EQ(SlicesOf({-5, 20}, 9), (Slices{0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(ContourFill, SlicesBeyondPlanesAreAtMostHalfTheirDistance)
{
  EXPECT_EQ(SlicesBeyondPlanes({4}), 1);
  EXPECT_EQ(SlicesBeyondPlanes({4, 3, 4, 5}), 1);
  EXPECT_EQ(SlicesBeyondPlanes({0, 6, 3, 3}), 2);
  EXPECT_EQ(SlicesBeyondPlanes({}), 1);
}

TEST(ContourFill, NearestPlaneFillsSlice)
{
  const Voxels voxels =
      VoxelsOf({Square(0.5, 1.5, 1.4), Square(0.5, 2.5, 1.1), Square(0.5, 3.5, 0.7)}, {4, 4, 3});
  EXPECT_EQ(voxels.size(), 4u);
}

TEST(ContourFill, RejectsMoreCrossingsThanAllowed)
{
  const std::vector<SliceContour> square{Square(0, 100, 0)};
  ContourFill fill("a", {200, 200, 1}, 250);
  EXPECT_EQ(fill.Runs(square).size(), 100u);
  EXPECT_TRUE(Contains(MessageOf([&] { fill.Runs(square); }), "go to and fro too often"));
}
} // namespace
} // namespace palpate::contour_fill_test
