#include "FalconKinematics.h"

#include "FalconVectors.h"
#include "RandomShapes.h"
#include "VirtualMechanism.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace palpate::falcon_kinematics_test
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
const Vector3 Center(0.0, 0.0, 125.0); // mm

// Uniform in the sphere that programs use as the Falcon's workspace.
Vector3 RandomPosition(test::Random& random, double radius = 40.0)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  return Center + radius * std::cbrt(unit(random)) * test::RandomDirection(random);
}

TEST(FalconKinematics, PositionsMatchTable)
{
  const auto path = test::FalconVectorsPath("falcon_fk_vectors.csv");
  PALPATE_REQUIRE_FILE(path);
  const FalconKinematics kinematics{FalconGeometry()};
  const auto rows = test::ReadRows(path);
  EXPECT_EQ(rows.size(), 29U);
  for (const auto& row : rows)
  {
    const Vector3 angles = kinematics.AnglesOf({row[0], row[1], row[2]});
    const Vector3 degrees = angles * (180.0 / M_PI);
    // The table used pi as 3.14159265, which is off by 1e-7 degrees at 90.
    EXPECT_LT((degrees - Vector3(row[3], row[4], row[5])).cwiseAbs().maxCoeff(), 1.5e-7);
    Vector3 position;
    ASSERT_TRUE(kinematics.PositionAt(angles, kinematics.Center(), position));
    // Nine digits of a metre, plus the effect of that pi: 4e-10 m at most.
    EXPECT_LT((1e-3 * position - Vector3(row[6], row[7], row[8])).cwiseAbs().maxCoeff(), 9.1e-10)
        << row[0] << " " << row[1] << " " << row[2];
  }
}

// The widely used library is wrong here: its z column of the Jacobian has an extra sine, and its
// transposition overwrites itself. Its columns of the table are ignored.
TEST(FalconKinematics, TorquesMatchTable)
{
  const auto path = test::FalconVectorsPath("falcon_force_vectors.csv");
  PALPATE_REQUIRE_FILE(path);
  const FalconKinematics kinematics{FalconGeometry()};
  const auto rows = test::ReadRows(path);
  EXPECT_EQ(rows.size(), 26U);
  for (const auto& row : rows)
  {
    const Vector3 position = 1e3 * Vector3(row[0], row[1], row[2]);
    Vector3 angles;
    Vector3 torques;
    ASSERT_TRUE(kinematics.AnglesAt(position, angles));
    ASSERT_TRUE(kinematics.TorquesFor({row[3], row[4], row[5]}, position, torques));
    const Vector3 degrees = angles * (180.0 / M_PI);
    EXPECT_LT((degrees - Vector3(row[6], row[7], row[8])).cwiseAbs().maxCoeff(), 1.5e-7);
    // Nine digits of a newton metre, and the table's pi.
    EXPECT_LT((1e-3 * torques - Vector3(row[9], row[10], row[11])).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((-10.0 * torques - Vector3(row[12], row[13], row[14])).cwiseAbs().maxCoeff(), 6e-5);
  }
}

TEST(FalconKinematics, JacobianIsDerivativeOfAngles)
{
  const FalconKinematics kinematics{FalconGeometry()};
  test::Random random(11);
  constexpr double h = 1e-3; // mm
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 position = RandomPosition(random);
    Matrix3 jacobian;
    ASSERT_TRUE(kinematics.Jacobian(position, jacobian));
    for (int axis = 0; axis < 3; ++axis)
    {
      Vector3 ahead;
      Vector3 behind;
      ASSERT_TRUE(kinematics.AnglesAt(position + h * Vector3::Unit(axis), ahead));
      ASSERT_TRUE(kinematics.AnglesAt(position - h * Vector3::Unit(axis), behind));
      // Entries are about 0.02 rad/mm; differences have an error of h^2 times the third derivative
      // (1e-6 of 1e-5) plus rounding over h (1e-16 / 1e-3).
      const Vector3 difference = (ahead - behind) / (2.0 * h);
      ASSERT_LT((difference - jacobian.col(axis)).cwiseAbs().maxCoeff(), 1e-10) << position;
    }
  }
}

// To the digits of the published facts.
TEST(FalconKinematics, JacobianMatchesKnownEntries)
{
  const FalconKinematics kinematics{FalconGeometry()};
  Matrix3 jacobian;
  ASSERT_TRUE(kinematics.Jacobian({10.0, -20.0, 120.0}, jacobian));
  Matrix3 known; // rad/m
  known << 4.31641444793, -12.0266921355, 11.1230868771, -10.1363812546, -0.617967334237,
      14.5072528549, 9.74627138977, 5.04877891473, 13.8062913532;
  // They were computed with pi = 3.14159265, which rotates legs by 2e-9 rad.
  EXPECT_LT((1e3 * jacobian - known).cwiseAbs().maxCoeff(), 4e-8);
}

TEST(FalconKinematics, AnglesMatchIntersectionOfSurfaces)
{
  const FalconKinematics kinematics{FalconGeometry()};
  const test::VirtualMechanism mechanism{test::VirtualMechanismSettings()};
  test::Random random(12);
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 position = RandomPosition(random);
    Vector3 angles;
    ASSERT_TRUE(kinematics.AnglesAt(position, angles));
    const auto others = mechanism.AnglesAt(position);
    // The root of a difference of squares, of which 1e-16 of 1e4 is lost; near 0 that matters.
    EXPECT_LT((angles - Vector3(others[0], others[1], others[2])).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(FalconKinematics, ForwardInvertsInverseFromAnyStart)
{
  const FalconKinematics kinematics{FalconGeometry()};
  test::Random random(13);
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 position = RandomPosition(random);
    Vector3 angles;
    ASSERT_TRUE(kinematics.AnglesAt(position, angles)) << position;
    Vector3 found;
    ASSERT_TRUE(kinematics.PositionAt(angles, RandomPosition(random), found)) << position;
    // Angles within 1e-12 rad; 1 rad moves the grip by less than 100 mm.
    ASSERT_LT((found - position).norm(), 1e-9) << position;
  }
}

TEST(FalconKinematics, ForwardInvertsInverseAtEdgesOfReach)
{
  const FalconKinematics kinematics{FalconGeometry()};
  test::Random random(14);
  int reached = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 position = RandomPosition(random, 120.0);
    Vector3 angles;
    if (kinematics.AnglesAt(position, angles))
    {
      Vector3 found;
      if (kinematics.PositionAt(angles, kinematics.Center(), found))
      {
        ++reached;
        ASSERT_LT((found - position).norm(), 1e-6) << position;
      }
    }
  }
  EXPECT_GT(reached, 4000);
}

TEST(FalconKinematics, PositionsHaveRequestedAngles)
{
  const FalconKinematics kinematics{FalconGeometry()};
  test::Random random(15);
  std::uniform_int_distribution<int> counts(-1780, 1780);
  int none = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 angles =
        kinematics.AnglesOf(Vector3(counts(random), counts(random), counts(random)));
    Vector3 position(NaN, 1.0, 2.0);
    if (!kinematics.PositionAt(angles, kinematics.Center(), position))
    {
      EXPECT_TRUE(std::isnan(position[0])) << "without a solution the result must not change";
      ++none;
      continue;
    }
    Vector3 back;
    ASSERT_TRUE(kinematics.AnglesAt(position, back));
    ASSERT_LT((back - angles).cwiseAbs().maxCoeff(), 1e-9);
  }
  // Only if two legs are far out and one far in, or the reverse.
  EXPECT_GT(none, 0);
  EXPECT_LT(none, 400);
}

TEST(FalconKinematics, OutOfReachHasNoSolution)
{
  const FalconKinematics kinematics{FalconGeometry()};
  for (const Vector3& position :
       {Vector3(0.0, 0.0, 400.0), Vector3(200.0, 0.0, 120.0), Vector3(0.0, 0.0, -110.0),
        Vector3(0.0, 0.0, 0.0), Vector3(NaN, 0.0, 120.0), Vector3(0.0, 0.0, NaN),
        Vector3(std::numeric_limits<double>::infinity(), 0.0, 120.0), Vector3(1e300, 0.0, 1e300)})
  {
    Vector3 result(1.0, 2.0, 3.0);
    Matrix3 jacobian;
    EXPECT_FALSE(kinematics.AnglesAt(position, result)) << position;
    EXPECT_FALSE(kinematics.TorquesFor(Vector3::UnitX(), position, result));
    EXPECT_FALSE(kinematics.Jacobian(position, jacobian));
    EXPECT_EQ(kinematics.LeastForce(1.0, position), 0.0);
    EXPECT_EQ(result, Vector3(1.0, 2.0, 3.0));
  }
  for (const Vector3& angles : {Vector3(NaN, 0.5, 0.5), Vector3(3.0, 0.5, 0.5),
                                Vector3(1.7, 1.7, -0.5), Vector3(1e300, 0.0, 0.0)})
  {
    Vector3 result(1.0, 2.0, 3.0);
    EXPECT_FALSE(kinematics.PositionAt(angles, Center, result)) << angles;
    EXPECT_EQ(result, Vector3(1.0, 2.0, 3.0));
  }
  Vector3 result;
  EXPECT_FALSE(kinematics.TorquesFor({NaN, 0.0, 0.0}, Center, result));
}

TEST(FalconKinematics, InvalidStartDoesNotMatter)
{
  const FalconKinematics kinematics{FalconGeometry()};
  const Vector3 angles = kinematics.AnglesOf(Vector3::Zero());
  for (const Vector3& start : {Vector3(NaN, 0.0, 0.0), Vector3(0.0, 0.0, 1e9)})
  {
    Vector3 position;
    ASSERT_TRUE(kinematics.PositionAt(angles, start, position));
    EXPECT_NEAR(position[2], 134.602428, 1e-6);
  }
}

TEST(FalconKinematics, TorquesDoWorkOfForce)
{
  const FalconKinematics kinematics{FalconGeometry()};
  test::Random random(16);
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 position = RandomPosition(random);
    const Vector3 force = 5.0 * test::RandomDirection(random);
    const Vector3 step = 1e-4 * test::RandomDirection(random);
    Vector3 torques;
    Vector3 from;
    Vector3 to;
    ASSERT_TRUE(kinematics.TorquesFor(force, position, torques));
    ASSERT_TRUE(kinematics.AnglesAt(position - step, from));
    ASSERT_TRUE(kinematics.AnglesAt(position + step, to));
    // 1e-3 N mm of work; differences have an error of the square of the distance, of 100 mm.
    EXPECT_NEAR(torques.dot(to - from), force.dot(2.0 * step), 1e-12 * 1e3);
  }
}

TEST(FalconKinematics, LeastForceIsSharp)
{
  const FalconKinematics kinematics{FalconGeometry()};
  test::Random random(17);
  const double torque = 600.0; // N mm
  const double least = kinematics.LeastForce(torque, Center);
  double largest = 0.0;
  for (int i = 0; i < 100000; ++i)
  {
    Vector3 torques;
    ASSERT_TRUE(kinematics.TorquesFor(least * test::RandomDirection(random), Center, torques));
    largest = std::max(largest, torques.cwiseAbs().maxCoeff());
  }
  EXPECT_LE(largest, torque * (1.0 + 1e-12));
  // The closest of so many directions is off by a percent of angle, which enters squared.
  EXPECT_GT(largest, torque * (1.0 - 1e-3));
  // The published 9.2 N for 4095 values at 6616 a N m.
  EXPECT_NEAR(kinematics.LeastForce(4095.0 / 6.616, Center), 9.2, 0.05);
}
} // namespace
} // namespace palpate::falcon_kinematics_test
