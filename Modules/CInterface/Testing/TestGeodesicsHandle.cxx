#include "Handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace palpate::geodesics_handle_test
{
namespace
{
using namespace palpate::test;

constexpr double HalfTurn = 20.0 * 3.14159265358979323846; // mm, of BallModel
constexpr double Right[3] = {25.0, 0.0, 0.0};
constexpr double Left[3] = {-25.0, 0.0, 0.0};
constexpr double Front[3] = {0.0, 25.0, 0.0};

Owned<palpate_geodesics> OfBall()
{
  return Owned<palpate_geodesics>(palpate_geodesics_of_model(BallModel().get(), nullptr));
}

// A square of two triangles.
Owned<palpate_geodesics> OfSquare()
{
  constexpr double Points[12] = {0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0};
  constexpr int32_t Triangles[6] = {0, 1, 2, 0, 2, 3};
  const Owned<palpate_compared> body(palpate_compared_of_mesh(Points, 4, Triangles, 2, nullptr));
  return Owned<palpate_geodesics>(palpate_geodesics_of_body(body.get(), nullptr));
}

TEST(GeodesicsHandle, OfASphereAreGreatCircles)
{
  const auto surface = OfBall();
  ASSERT_NE(surface, nullptr);
  palpate_geodesic found;
  std::size_t count = 0;
  ASSERT_EQ(
      palpate_geodesics_find(surface.get(), Right, Front, &found, nullptr, 0, &count, nullptr), 1);
  EXPECT_NEAR(found.along, 0.5 * HalfTurn, 1e-4);
  EXPECT_NEAR(found.straight, 20.0 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(found.from[0], 20.0, 1e-9);
  EXPECT_LT(found.uncertainty, 1e-3);
  std::vector<double> path(3 * count);
  palpate_geodesics_find(surface.get(), Right, Front, &found, path.data(), count, &count, nullptr);
  for (std::size_t n = 0; n < path.size(); n += 3)
  {
    EXPECT_NEAR(std::hypot(path[n], path[n + 1], path[n + 2]), 20.0, 1e-9);
  }
}

TEST(GeodesicsHandle, MapReachesTheOppositePole)
{
  const auto surface = OfBall();
  std::size_t points = 0;
  std::size_t triangles = 0;
  ASSERT_EQ(palpate_geodesics_map(surface.get(), Right, &points, &triangles, nullptr, nullptr,
                                  nullptr, nullptr),
            1);
  std::vector<double> places(3 * points);
  std::vector<double> distances(points);
  std::vector<int32_t> corners(3 * triangles);
  ASSERT_EQ(palpate_geodesics_map(surface.get(), Right, &points, &triangles, places.data(),
                                  corners.data(), distances.data(), nullptr),
            1);
  for (std::size_t n = 0; n < points; ++n)
  {
    // The drawing's triangles are shorter than the sphere.
    EXPECT_NEAR(distances[n], 20.0 * std::acos(std::clamp(places[3 * n] / 20.0, -1.0, 1.0)), 0.02);
  }
}

TEST(GeodesicsHandle, OfTrianglesRunAlongThem)
{
  const auto square = OfSquare();
  ASSERT_NE(square, nullptr);
  constexpr double First[3] = {1, 1, 5};
  constexpr double Second[3] = {9, 7, -5};
  palpate_geodesic found;
  std::size_t count = 0;
  std::array<double, 3> path{};
  ASSERT_EQ(
      palpate_geodesics_find(square.get(), First, Second, &found, path.data(), 1, &count, nullptr),
      1);
  EXPECT_NEAR(found.along, 10.0, 1e-12);
  EXPECT_TRUE(std::isnan(found.uncertainty));
  EXPECT_GE(count, 2U);
  EXPECT_EQ(path, (std::array<double, 3>{1, 1, 0}));
}

TEST(GeodesicsHandle, PlacesThatAreNotFiniteAreRefused)
{
  const auto surface = OfBall();
  const double bad[3] = {0.0, std::numeric_limits<double>::infinity(), 0.0};
  palpate_geodesic found;
  std::size_t count = 0;
  palpate_error error;
  EXPECT_EQ(palpate_geodesics_find(surface.get(), Left, bad, &found, nullptr, 0, &count, &error),
            0);
  EXPECT_STREQ(error.text, "a place is not finite");
  EXPECT_EQ(
      palpate_geodesics_map(surface.get(), bad, &count, &count, nullptr, nullptr, nullptr, &error),
      0);
}
} // namespace
} // namespace palpate::geodesics_handle_test
