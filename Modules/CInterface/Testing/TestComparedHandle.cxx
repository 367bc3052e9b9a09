#include "Handles.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace palpate::compared_handle_test
{
namespace
{
using namespace palpate::test;

Owned<palpate_compared> BallOf(double radius)
{
  const double coefficient = radius * std::sqrt(4.0 * M_PI);
  const double center[3] = {1.0, 2.0, 3.0};
  const Owned<palpate_model> model(palpate_model_create(0, &coefficient, center, nullptr));
  return Owned<palpate_compared>(palpate_compared_of_model(model.get(), nullptr));
}

TEST(ComparedHandle, ModelsOfSpheresHaveTheirExactDistances)
{
  const Owned<palpate_compared> first = BallOf(22.0);
  const Owned<palpate_compared> reference = BallOf(20.0);
  ASSERT_NE(first, nullptr);
  const double tolerances[2] = {1.0, 3.0};
  palpate_comparison found{};
  double surfaceDice[2];
  std::vector<double> distances(palpate_compared_point_count(first.get()));
  palpate_error error{};
  ASSERT_EQ(palpate_compare(first.get(), reference.get(), tolerances, 2, &found, surfaceDice,
                            distances.data(), nullptr, &error),
            1)
      << error.text;
  EXPECT_NEAR(found.both.mean, 2.0, 1e-9);
  EXPECT_NEAR(found.to_reference.signed_mean, 2.0, 1e-9);
  EXPECT_NEAR(found.hausdorff95, 2.0, 1e-9);
  EXPECT_NEAR(found.side_bias[3], 2.0, 1e-9);
  EXPECT_NEAR(found.volumes[1], 4.0 / 3.0 * M_PI * 8000.0, 1e-6);
  EXPECT_EQ(surfaceDice[0], 0.0);
  EXPECT_EQ(surfaceDice[1], 1.0);
  EXPECT_NEAR(*std::min_element(distances.begin(), distances.end()), 2.0, 1e-9);
  EXPECT_NEAR(found.dice, 2.0 / (1.0 + std::pow(1.1, 3)), 3e-4);
}

TEST(ComparedHandle, ABallInAnotherIsRelatedToIt)
{
  const Owned<palpate_compared> inner = BallOf(7.0);
  const Owned<palpate_compared> outer = BallOf(9.0);
  const double margins[2] = {1.0, 3.0};
  palpate_relation found{};
  double areas[4];
  double volumes[4];
  palpate_error error{};
  ASSERT_EQ(
      palpate_relate(inner.get(), outer.get(), 2.5, margins, 2, &found, areas, volumes, &error), 1)
      << error.text;
  EXPECT_EQ(found.kind, 2);
  EXPECT_EQ(found.distance, 0.0);
  EXPECT_NEAR(found.wall, 2.0, 0.01);
  EXPECT_NEAR(found.shared_volume, 4.0 / 3.0 * M_PI * 343.0, 1e-6);
  EXPECT_NEAR(found.contact_areas[0], 196.0 * M_PI, 1.0); // of triangles
  EXPECT_EQ(areas[0], 1.0) << "it lies inside";
  EXPECT_EQ(areas[1], 0.0) << "nothing is within 1 mm of the smaller one";
  EXPECT_EQ(areas[3], 1.0);
  const double unsorted[2] = {3.0, 1.0};
  EXPECT_EQ(
      palpate_relate(inner.get(), outer.get(), 1.0, unsorted, 2, &found, areas, volumes, nullptr),
      0);
}

TEST(ComparedHandle, AMirrorImageComesBackOntoItsBody)
{
  // An egg that mirroring turns round, at the other side of the plane.
  std::vector<double> coefficients(16, 0.0);
  coefficients[0] = 20.0 * std::sqrt(4.0 * M_PI);
  coefficients[3] = 5.0; // along x
  coefficients[7] = 4.0;
  coefficients[12] = 3.0;
  const double here[3] = {30.0, 4.0, 5.0};
  const Owned<palpate_model> model(palpate_model_create(3, coefficients.data(), here, nullptr));
  coefficients[3] = -5.0;
  coefficients[7] = -4.0; // harmonics of odd order along x
  const double there[3] = {-30.0, 4.0, 5.0};
  const Owned<palpate_model> other(palpate_model_create(3, coefficients.data(), there, nullptr));
  const Owned<palpate_compared> left(palpate_compared_of_model(model.get(), nullptr));
  const Owned<palpate_compared> right(palpate_compared_of_model(other.get(), nullptr));
  double turn = 1.0;
  double shift[3];
  palpate_error error{};
  const Owned<palpate_compared> mirrored(
      palpate_compared_mirror(right.get(), left.get(), &turn, shift, &error));
  ASSERT_NE(mirrored, nullptr) << error.text;
  EXPECT_NEAR(turn, 0.0, 1e-3);
  palpate_comparison found{};
  ASSERT_EQ(palpate_compare(left.get(), mirrored.get(), nullptr, 0, &found, &turn, nullptr, nullptr,
                            &error),
            1)
      << error.text;
  EXPECT_LT(found.both.mean, 0.02); // of its triangles
  double volume = 0.0;
  double area = 0.0;
  palpate_compared_measure(right.get(), &volume, &area);
  EXPECT_NEAR(found.volumes[0], volume, 1e-6);
}

TEST(ComparedHandle, RaysFromTheTipsOfAnEllipsoidAreItsLength)
{
  std::vector<double> points(3 * palpate_mesh_point_count(16));
  std::vector<int32_t> triangles(3 * palpate_mesh_triangle_count(16));
  palpate_model_mesh(BallModel().get(), 16, points.data(), nullptr, triangles.data(), nullptr);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    points[i] *= 1.5;
  }
  const Owned<palpate_compared> body(palpate_compared_of_mesh(
      points.data(), points.size() / 3, triangles.data(), triangles.size() / 3, nullptr));
  std::vector<double> thickness(palpate_compared_point_count(body.get()));
  ASSERT_EQ(palpate_compared_ray_thickness(body.get(), thickness.data(), nullptr), 1);
  EXPECT_NEAR(*std::max_element(thickness.begin(), thickness.end()), 60.0, 0.1); // of triangles
  ASSERT_EQ(palpate_compared_thickness(body.get(), thickness.data(), nullptr), 1);
  EXPECT_LT(*std::max_element(thickness.begin(), thickness.end()), 41.0) << "balls do not reach";
}

TEST(ComparedHandle, ATubeHasItsCalibre)
{
  std::vector<uint8_t> inside(static_cast<std::size_t>(20) * 20 * 80, 0);
  for (std::size_t v = 0; v < inside.size(); ++v)
  {
    const double x = static_cast<double>(v % 20) - 9.5;
    const double y = static_cast<double>(v / 20 % 20) - 9.5;
    const std::size_t z = v / 400;
    inside[v] = std::hypot(x, y) <= 5.0 && z >= 5 && z < 75 ? 1 : 0;
  }
  const int size[3] = {20, 20, 80};
  const double origin[3] = {0.0, 0.0, 0.0};
  const double spacing[3] = {1.0, 1.0, 1.0};
  const double axes[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  palpate_error error{};
  const Owned<palpate_compared> tube(
      palpate_compared_of_mask_shape(inside.data(), size, origin, spacing, axes, &error));
  ASSERT_NE(tube, nullptr) << error.text;
  double length = 0.0;
  const std::size_t count = palpate_compared_calibre(tube.get(), nullptr, 0, &length, &error);
  ASSERT_GT(count, 10U) << error.text;
  EXPECT_NEAR(length, 70.0, 1.0);
  std::vector<palpate_section> sections(count);
  EXPECT_EQ(palpate_compared_calibre(tube.get(), sections.data(), count, &length, &error), count);
  for (const palpate_section& one : sections)
  {
    EXPECT_NEAR(one.area, 25.0 * M_PI, 4.0); // of voxels
    EXPECT_NEAR(one.center[0], 9.5, 0.1);
    EXPECT_NEAR(std::abs(one.axis[2]), 1.0, 0.01);
  }
  EXPECT_EQ(palpate_compared_calibre(BallOf(7.0).get(), nullptr, 0, &length, &error), 0U);
  EXPECT_EQ(std::string(error.text).find("the body is not long"), 0U) << error.text;
}

TEST(ComparedHandle, ABallIsRoundAndAsThickAsItsDiameter)
{
  const Owned<palpate_compared> ball = BallOf(7.0);
  palpate_shape shape{};
  ASSERT_EQ(palpate_compared_shape(ball.get(), &shape, nullptr), 1);
  EXPECT_NEAR(shape.sphericity, 1.0, 1e-3);
  EXPECT_NEAR(shape.maximum_diameter, 14.0, 0.01);
  EXPECT_NEAR(shape.volume_density_hull, 1.0, 1e-6);
  EXPECT_NEAR(shape.centroid[2], 3.0, 1e-3);
  std::vector<double> thickness(palpate_compared_point_count(ball.get()));
  ASSERT_EQ(palpate_compared_thickness(ball.get(), thickness.data(), nullptr), 1);
  EXPECT_NEAR(*std::min_element(thickness.begin(), thickness.end()), 14.0, 0.03);
}

TEST(ComparedHandle, MasksAreComparedByVoxels)
{
  const int size[3] = {10, 8, 6};
  const double origin[3] = {0.0, 0.0, 0.0};
  const double spacing[3] = {1.0, 1.0, 2.0};
  const double axes[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  std::vector<uint8_t> inside(480, 0);
  palpate_error error{};
  EXPECT_EQ(palpate_compared_of_mask(inside.data(), size, origin, spacing, axes, &error), nullptr);
  EXPECT_STREQ(error.text, "the mask has no voxels");
  std::fill_n(inside.begin() + 80, 240, 255); // slices 1 to 3
  const Owned<palpate_compared> one(
      palpate_compared_of_mask(inside.data(), size, origin, spacing, axes, &error));
  std::fill_n(inside.begin() + 80, 80, 0);
  const Owned<palpate_compared> other(
      palpate_compared_of_mask(inside.data(), size, origin, spacing, axes, &error));
  ASSERT_NE(other, nullptr) << error.text;
  palpate_comparison found{};
  ASSERT_EQ(palpate_compare(one.get(), other.get(), nullptr, 0, &found, nullptr, nullptr, nullptr,
                            &error),
            1);
  EXPECT_DOUBLE_EQ(found.dice, 2.0 * 160.0 / (240.0 + 160.0));
  EXPECT_DOUBLE_EQ(found.jaccard, 160.0 / 240.0);
  EXPECT_DOUBLE_EQ(found.volumes[0], 480.0);
}

TEST(ComparedHandle, MeshWithWrongIndicesIsRefused)
{
  const double points[9] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
  const int32_t triangle[3] = {0, 1, 3};
  palpate_error error{};
  EXPECT_EQ(palpate_compared_of_mesh(points, 3, triangle, 1, &error), nullptr);
  EXPECT_NE(error.text[0], '\0');
  const Owned<palpate_compared> ball = BallOf(10.0);
  const double tolerance = -1.0;
  palpate_comparison found{};
  double surfaceDice = 0.0;
  EXPECT_EQ(palpate_compare(ball.get(), ball.get(), &tolerance, 1, &found, &surfaceDice, nullptr,
                            nullptr, &error),
            0);
}
} // namespace
} // namespace palpate::compared_handle_test
