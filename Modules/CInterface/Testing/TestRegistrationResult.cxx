#include "Handles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace palpate::registration_result_test
{
namespace
{
using namespace palpate::test;
using Map = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

Eigen::Affine3d Truth()
{
  Eigen::Affine3d map(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()));
  map.pretranslate(Eigen::Vector3d(4, -7, 2));
  return map;
}

std::vector<double> Scatter(std::size_t count)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 20.0);
  std::vector<double> points(3 * count);
  for (double& one : points)
  {
    one = normal(random);
  }
  return points;
}

std::vector<double> Moved(const std::vector<double>& points, const Eigen::Affine3d& map)
{
  std::vector<double> moved(points.size());
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    const Eigen::Vector3d at = map * Eigen::Vector3d(&points[i]);
    std::copy(at.begin(), at.end(), &moved[i]);
  }
  return moved;
}

// An ellipsoid without symmetries of rotation but half turns.
Owned<palpate_compared> Ellipsoid(std::vector<double>& points)
{
  points.resize(3 * palpate_mesh_point_count(12));
  std::vector<int32_t> triangles(3 * palpate_mesh_triangle_count(12));
  palpate_model_mesh(BallModel().get(), 12, points.data(), nullptr, triangles.data(), nullptr);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    points[i] *= 1.5;
    points[i + 1] *= 0.7;
  }
  return Owned<palpate_compared>(palpate_compared_of_mesh(
      points.data(), points.size() / 3, triangles.data(), triangles.size() / 3, nullptr));
}

TEST(RegistrationResult, LandmarksFindTheExactMap)
{
  const std::vector<double> moving = Scatter(10);
  std::vector<double> fixed = Moved(moving, Truth());
  std::swap(fixed[0], fixed[3]); // two of ten are wrong
  std::vector<double> residuals(10);
  std::vector<double> weights(10);
  palpate_registration found{};
  palpate_error error{};
  ASSERT_EQ(palpate_register_landmarks(moving.data(), fixed.data(), 10, 0, 0.01, &found,
                                       residuals.data(), weights.data(), &error),
            1)
      << error.text;
  EXPECT_LT((Eigen::Map<Map>(found.map) - Truth().matrix()).norm(), 1e-3); // of the weights' tails
  EXPECT_LT(weights[1], 0.1);
  EXPECT_GT(weights[5], 0.9);
  EXPECT_LT(residuals[5], 1e-3);
  EXPECT_TRUE(std::isnan(found.median));
}

TEST(RegistrationResult, PointsReturnToTheirSurface)
{
  std::vector<double> points;
  const Owned<palpate_compared> surface = Ellipsoid(points);
  const Eigen::Affine3d back = Truth().inverse();
  const std::vector<double> away = Moved(points, back);
  const Map near = (Eigen::Translation3d(1.0, 0.5, -1.0) * Truth()).matrix();
  palpate_registration found{};
  palpate_error error{};
  ASSERT_EQ(palpate_register_points(away.data(), away.size() / 3, surface.get(), 0, 0.0,
                                    near.data(), &found, &error),
            1)
      << error.text;
  EXPECT_EQ(found.has_converged, 1);
  EXPECT_LT((Eigen::Map<Map>(found.map) - Truth().matrix()).norm(), 1e-4);
  EXPECT_LT(found.rms, 1e-5);
}

TEST(RegistrationResult, BodiesFindEachOtherFromTheirCentroids)
{
  std::vector<double> points;
  const Owned<palpate_compared> fixed = Ellipsoid(points);
  std::vector<double> away = Moved(points, Truth().inverse());
  std::vector<int32_t> triangles(3 * palpate_mesh_triangle_count(12));
  std::vector<double> ball(points.size());
  palpate_model_mesh(BallModel().get(), 12, ball.data(), nullptr, triangles.data(), nullptr);
  const Owned<palpate_compared> moving(palpate_compared_of_mesh(
      away.data(), away.size() / 3, triangles.data(), triangles.size() / 3, nullptr));
  palpate_registration found{};
  palpate_error error{};
  ASSERT_EQ(palpate_register_bodies(moving.get(), fixed.get(), 0, 0.0, nullptr, &found, &error), 1)
      << error.text;
  EXPECT_EQ(found.has_converged, 1);
  EXPECT_LT((Eigen::Map<Map>(found.map) - Truth().matrix()).norm(), 1e-4);
  // The ellipsoid also fits after half a turn, if it starts there.
  const Map turned = (Truth() * Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitZ())).matrix();
  ASSERT_EQ(
      palpate_register_bodies(moving.get(), fixed.get(), 0, 0.0, turned.data(), &found, &error), 1)
      << error.text;
  EXPECT_GT((Eigen::Map<Map>(found.map) - Truth().matrix()).norm(), 1.0) << "the start counts";
  EXPECT_EQ(palpate_register_bodies(moving.get(), fixed.get(), 4, 0.0, nullptr, &found, &error), 0);
  EXPECT_STREQ(error.text, "the kind of a registration is 0, 1 or 2");
}

TEST(RegistrationResult, RefusesInASentence)
{
  const std::vector<double> points = Scatter(10);
  std::vector<double> residuals(10);
  std::vector<double> weights(10);
  palpate_registration found{};
  palpate_error error{};
  EXPECT_EQ(palpate_register_landmarks(points.data(), points.data(), 2, 0, 0.0, &found,
                                       residuals.data(), weights.data(), &error),
            0);
  EXPECT_EQ(std::string(error.text).find("the registration needs at least three"), 0U);
  EXPECT_EQ(palpate_register_landmarks(points.data(), points.data(), 10, 3, 0.0, &found,
                                       residuals.data(), weights.data(), &error),
            0);
  EXPECT_STREQ(error.text, "the kind of a registration is 0, 1 or 2");
  std::vector<double> mesh;
  const Owned<palpate_compared> surface = Ellipsoid(mesh);
  const std::array<double, 16> zero{};
  EXPECT_EQ(palpate_register_points(points.data(), 10, surface.get(), 0, 0.0, zero.data(), &found,
                                    &error),
            0);
  EXPECT_NE(std::string(error.text).find("no matrix of a map"), std::string::npos);
}

TEST(RegistrationResult, MotionOfABodyIsThatOfItsPoints)
{
  std::vector<double> points;
  const Owned<palpate_compared> before = Ellipsoid(points);
  const std::vector<double> moved = Moved(points, Truth());
  std::vector<int32_t> triangles(3 * palpate_mesh_triangle_count(12));
  std::vector<double> unused(points.size());
  palpate_model_mesh(BallModel().get(), 12, unused.data(), nullptr, triangles.data(), nullptr);
  const Owned<palpate_compared> after(palpate_compared_of_mesh(
      moved.data(), moved.size() / 3, triangles.data(), triangles.size() / 3, nullptr));
  palpate_motion motion{};
  std::array<double, 3> landmark{};
  palpate_error error{};
  ASSERT_EQ(palpate_compared_motion(before.get(), after.get(), points.data(), 1, &motion,
                                    landmark.data(), &error),
            1)
      << error.text;
  EXPECT_NEAR(motion.turn, 0.3, 1e-4);
  EXPECT_NEAR(motion.shift[1], -7.0, 1e-3);
  EXPECT_LT(motion.rest, 1e-4);
  EXPECT_NEAR(landmark[0], moved[0], 1e-3);
}
} // namespace
} // namespace palpate::registration_result_test
