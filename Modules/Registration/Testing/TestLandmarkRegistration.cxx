#include "LandmarkRegistration.h"

#include "RandomMaps.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <utility>

namespace palpate::landmark_registration_test
{
namespace
{
using Points = std::vector<Vector3>;

// Places on an organ's surface, about 25 mm from its middle.
Points Landmarks(test::Random& random, std::size_t count)
{
  Points points(count);
  std::generate(points.begin(), points.end(),
                [&random] { return Vector3(25.0 * test::RandomVector(random, 1.0).normalized()); });
  return points;
}

Points Mapped(const Points& points, const Eigen::Affine3d& map, test::Random& random, double noise)
{
  Points mapped;
  for (const Vector3& point : points)
  {
    mapped.emplace_back(map * point + test::RandomVector(random, noise));
  }
  return mapped;
}

// Share of draws within 1 mm and 3 degrees, of a start 10 mm and 10 degrees off.
template <typename Register>
double ShareWithin(std::size_t pairs, std::size_t exchanged, const Register& run)
{
  constexpr int Draws = 1000;
  test::Random random(5);
  int good = 0;
  for (int draw = 0; draw < Draws; ++draw)
  {
    const Points moving = Landmarks(random, pairs);
    const Eigen::Affine3d truth = test::RandomMove(random, 10.0, M_PI / 18.0);
    Points fixed = Mapped(moving, truth, random, 1.0);
    for (std::size_t k = 0; k < exchanged; k += 2)
    {
      std::swap(fixed[k], fixed[k + 1]);
    }
    const test::MapSize left(truth.inverse() * run(moving, fixed));
    good += left.Shift <= 1.0 && left.Turn <= M_PI / 60.0 ? 1 : 0;
  }
  return static_cast<double>(good) / Draws;
}

Eigen::Affine3d Robust(const Points& moving, const Points& fixed)
{
  LandmarkRegistration made;
  EXPECT_TRUE(RegisterLandmarks(moving, fixed, RegistrationKind::Rigid, 1.0, made).IsOk());
  return made.Map;
}

// Plain least squares, by Eigen.
Eigen::Affine3d Plain(const Points& moving, const Points& fixed)
{
  const auto columns = [](const Points& points)
  {
    Eigen::Matrix3Xd matrix(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      matrix.col(static_cast<Eigen::Index>(i)) = points[i];
    }
    return matrix;
  };
  return Eigen::Affine3d(Eigen::umeyama(columns(moving), columns(fixed), false));
}

TEST(LandmarkRegistration, FindsTheExactMapOfEachKind)
{
  test::Random random(4);
  Eigen::Affine3d map = test::RandomMove(random, 30.0, 2.5);
  for (const RegistrationKind kind :
       {RegistrationKind::Rigid, RegistrationKind::Similarity, RegistrationKind::Affine})
  {
    const Points moving = Landmarks(random, 6);
    LandmarkRegistration made;
    ASSERT_TRUE(
        RegisterLandmarks(moving, Mapped(moving, map, random, 0.0), kind, 0.0, made).IsOk());
    EXPECT_NEAR((made.Map.matrix() - map.matrix()).norm(), 0.0, 1e-11);
    EXPECT_NEAR(made.Rms, 0.0, 1e-12);
    map.linear() *= 1.3; // then, a shear
    map.linear()(0, 1) += kind == RegistrationKind::Similarity ? 0.4 : 0.0;
  }
}

TEST(LandmarkRegistration, NeverMirrors)
{
  test::Random random(6);
  const Points moving = Landmarks(random, 10);
  Points fixed = moving;
  for (Vector3& point : fixed)
  {
    point.x() = -point.x();
  }
  LandmarkRegistration made;
  ASSERT_TRUE(RegisterLandmarks(moving, fixed, RegistrationKind::Rigid, 1.0, made).IsOk());
  EXPECT_NEAR(made.Map.linear().determinant(), 1.0, 1e-12);
}

// 95 % of twelve with noise of 1 mm.
TEST(LandmarkRegistration, TwelveWithNoiseAreWithinAMillimeterAndThreeDegrees)
{
  EXPECT_GE(ShareWithin(12, 0, Robust), 0.95);
}

TEST(LandmarkRegistration, ExchangedPairsHarmLessThanByLeastSquares)
{
  EXPECT_GT(ShareWithin(8, 2, Robust), ShareWithin(8, 2, Plain) + 0.1);
  EXPECT_GT(ShareWithin(20, 4, Robust), 0.95);
}

TEST(LandmarkRegistration, WrongPairHasNoWeight)
{
  test::Random random(7);
  const Points moving = Landmarks(random, 10);
  Points fixed = Mapped(moving, test::RandomMove(random, 5.0, 0.1), random, 0.5);
  fixed[3] += Vector3(0.0, 25.0, 0.0);
  LandmarkRegistration made;
  ASSERT_TRUE(RegisterLandmarks(moving, fixed, RegistrationKind::Rigid, 0.5, made).IsOk());
  EXPECT_LT(made.Weights[3], 0.01);
  EXPECT_GT(made.Residuals[3], 20.0);
  EXPECT_GT(made.Weights[0], 0.2);
}

TEST(LandmarkRegistration, PredictsItsError)
{
  constexpr int Draws = 400;
  test::Random random(8);
  test::ErrorRatios errors;
  for (int draw = 0; draw < Draws; ++draw)
  {
    const Points moving = Landmarks(random, 30);
    LandmarkRegistration made;
    ASSERT_TRUE(RegisterLandmarks(moving, Mapped(moving, Eigen::Affine3d::Identity(), random, 1.0),
                                  RegistrationKind::Rigid, 0.0, made)
                    .IsOk());
    errors.Add(made.Map, made.Error);
  }
  EXPECT_NEAR(1.0 / errors.Turn(), 1.0, 0.3); // the bar for touched points
  EXPECT_NEAR(1.0 / errors.Shift(), 1.0, 0.3);
}

TEST(LandmarkRegistration, RefusesWhatDoesNotDetermineAMap)
{
  LandmarkRegistration made;
  const Points line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  const Points plane{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const Points two{{0, 0, 0}, {1, 0, 0}};
  const auto message = [&made](const Points& moving, const Points& fixed, RegistrationKind kind)
  { return RegisterLandmarks(moving, fixed, kind, 0.0, made).Message(); };
  EXPECT_EQ(message(line, line, RegistrationKind::Rigid), "has all landmarks on a line");
  EXPECT_EQ(message(plane, plane, RegistrationKind::Rigid), "");
  EXPECT_EQ(message(plane, plane, RegistrationKind::Affine), "has all landmarks in a plane");
  EXPECT_EQ(message(two, two, RegistrationKind::Rigid),
            "needs at least three pairs of landmarks, has 2");
  EXPECT_EQ(message(plane, two, RegistrationKind::Rigid),
            "has 4 landmarks for 2; each needs its partner");
  Points bad = plane;
  bad[1].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message(plane, bad, RegistrationKind::Rigid), "has landmarks that are not finite");
}
} // namespace
} // namespace palpate::landmark_registration_test
