#include "HeldFit.h"

#include "HeldCases.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::held_fit_test
{
namespace
{
using test::EllipsoidFit;
using test::MakeHeldFit;
using test::RandomMove;

constexpr double Period = 0.001; // s, of a servo

// Balls about one point: every point is at the same distance.
TEST(HeldFit, EnergyOfConcentricBallsIsThatOfTheirDistance)
{
  const double outer = 25.0;
  HeldFitSettings settings;
  for (const double gap : {0.5, 3.0, 6.0, 9.0, 10.5, 14.0})
  {
    const HeldFit fit = MakeHeldFit(test::Ellipsoid(16, Vector3::Constant(outer - gap)),
                                    test::Ellipsoid(16, Vector3::Constant(outer)), settings);
    const HeldForce made = fit.At(Eigen::Affine3d::Identity());
    const double ratio = std::min(1.0, gap * gap / (settings.Reach * settings.Reach));
    const double energy = fit.MostEnergy() * (1.0 - std::pow(1.0 - ratio, 3));
    // Facets of 1.3 mm lie up to 0.02 mm below the ball.
    EXPECT_NEAR(made.Energy, energy, 0.02 * fit.LargestForce() + 1e-12) << gap;
    EXPECT_LT(made.Force.norm(), 0.02) << gap; // by symmetry, of 128 points
    EXPECT_LE(made.Energy, fit.MostEnergy() * (1.0 + 1e-12));
  }
}

// A ball that is a little off in a ball of its size: distances e cos(t), whose mean square is
// e^2 / 3.
TEST(HeldFit, ShiftedBallIsPulledBackByAThirdOfTheStiffness)
{
  HeldFitSettings settings;
  settings.Reach = 12.0;
  settings.Points = 4000;
  const IndexedMesh ball = test::Ellipsoid(24, Vector3::Constant(25.0));
  const HeldFit fit = MakeHeldFit(ball, ball, settings);
  for (const Vector3& off : {Vector3(0.8, 0.0, 0.0), Vector3(-0.3, 0.5, 0.4)})
  {
    const HeldForce made = fit.At(Eigen::Affine3d(Eigen::Translation3d(off)));
    const Vector3 expected = -settings.Stiffness / 3.0 * off;
    EXPECT_LT((made.Force - expected).norm(), 0.03 * expected.norm()); // facets, and e / R
    EXPECT_LT(made.Torque.norm(), 0.05 * expected.norm());             // N mm: a ball has none
  }
}

// The stated energy is the one whose gradient the force is, in all six directions. From inside, the
// nearest point jumps over the edges of facets, which turns the force of one of 128 points by their
// angle of 0.1: at most k c / 128 * 0.1 = 4e-3 N.
TEST(HeldFit, ForceAndTorqueAreTheSlopeOfTheEnergy)
{
  test::Random random(2);
  const HeldFit fit = EllipsoidFit(10);
  constexpr double Step = 1e-4; // mm, and over 20 mm as rad
  constexpr double Arm = 20.0;
  int exact = 0;
  int all = 0;
  for (int draw = 0; draw < 60; ++draw)
  {
    const Eigen::Affine3d pose = RandomMove(random, 0.15 * draw, 0.01 * draw);
    const Vector3 pivot = pose * fit.Pivot();
    const HeldForce made = fit.At(pose);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3 unit = Vector3::Unit(axis);
      const auto slope = [&](const auto& motion)
      { return fit.At(motion(Step) * pose).Energy - fit.At(motion(-Step) * pose).Energy; };
      const double shift =
          slope([&](double step) { return Eigen::Affine3d(Eigen::Translation3d(step * unit)); });
      const double turn = slope(
          [&](double step)
          {
            return Eigen::Translation3d(pivot) * Eigen::AngleAxisd(step / Arm, unit) *
                   Eigen::Affine3d(Eigen::Translation3d(-pivot));
          });
      for (const double off :
           {made.Force[axis] + shift / (2.0 * Step), made.Torque[axis] / Arm + turn / (2.0 * Step)})
      {
        EXPECT_LT(std::abs(off), 4e-3) << draw;
        exact += std::abs(off) < 1e-6 ? 1 : 0;
        ++all;
      }
    }
  }
  EXPECT_GT(exact, 9 * all / 10);
}

TEST(HeldFit, ForceIsBoundedAndEndsBeyondTheReach)
{
  test::Random random(3);
  const HeldFit fit = EllipsoidFit(8);
  double longest = 0.0;
  for (int draw = 0; draw < 1500; ++draw)
  {
    const HeldForce made = fit.At(RandomMove(random, 0.05 * draw, 3.0));
    longest = std::max(longest, made.Force.norm());
    EXPECT_GE(made.Energy, 0.0);
    EXPECT_LE(made.Energy, fit.MostEnergy() * (1.0 + 1e-12));
  }
  EXPECT_LE(longest, fit.LargestForce());
  EXPECT_GT(longest, 0.1 * fit.LargestForce());
  const HeldForce far = fit.At(Eigen::Affine3d(Eigen::Translation3d(70.0, 0.0, 0.0)));
  EXPECT_EQ(far.Force, Vector3::Zero());
  EXPECT_NEAR(far.Energy, fit.MostEnergy(), 1e-12);
}

// What a servo gives the hand beyond what the energy loses, in a tick of any length.
TEST(HeldFit, TickGivesAtMostTheBoundMore)
{
  test::Random random(4);
  HeldFitSettings settings;
  settings.Points = 24;
  const HeldFit fit = EllipsoidFit(4, settings);
  double balance = 0.0; // N mm, of all ticks
  double bound = 0.0;
  Vector3 place = Vector3::Zero();
  const double first = fit.At(Eigen::Affine3d::Identity()).Energy;
  HeldForce felt = fit.At(Eigen::Affine3d::Identity());
  for (int tick = 0; tick < 100'000; ++tick)
  {
    // Through the middle of the fixed surface, too, where the nearest points jump.
    const double length = tick % 100 == 0 ? 20.0 : 0.05;
    const Vector3 next = 0.999 * place + test::RandomVector(random, length);
    const HeldForce then = fit.At(Eigen::Affine3d(Eigen::Translation3d(next)));
    const double given = felt.Force.dot(next - place);
    const double most =
        felt.Energy - then.Energy + 0.5 * fit.Stiffness() * (next - place).squaredNorm();
    ASSERT_LE(given, most + 1e-9) << tick;
    balance += given;
    bound += 0.5 * fit.Stiffness() * (next - place).squaredNorm();
    place = next;
    felt = then;
  }
  EXPECT_LE(balance, first - felt.Energy + bound + 1e-6);
}

// A hand of 0.2 kg that holds the surface, and a mechanism with the damping k T / 2, which any has
// (a Falcon's is some 0.001 N s/mm). Forces are held for a tick, in which the hand moves as physics
// has it: motion and surface together never gain energy.
TEST(HeldFit, HandNeverGainsEnergyInAMillionTicks)
{
  test::Random random(5);
  HeldFitSettings settings;
  settings.Points = 8;
  const HeldFit fit = EllipsoidFit(2, settings);
  constexpr double Mass = 0.2e-3; // N s^2/mm
  const double damping = 0.5 * fit.Stiffness() * Period;
  Vector3 place = Vector3::Zero();
  Vector3 velocity = Vector3::Zero();
  double before = 0.0;
  double worst = 0.0;
  for (int tick = 0; tick < 1'000'000; ++tick)
  {
    if (tick % 5000 == 0)
    {
      place = test::RandomVector(random, 8.0);
      velocity = test::RandomVector(random, 150.0);
      before = std::numeric_limits<double>::infinity();
    }
    const HeldForce felt = fit.At(Eigen::Affine3d(Eigen::Translation3d(place)));
    const double energy = felt.Energy + 0.5 * Mass * velocity.squaredNorm();
    worst = std::max(worst, energy - before);
    before = energy;
    // The mean of both velocities moves it, so that work and energy agree to rounding.
    const double half = 0.5 * damping * Period / Mass;
    const Vector3 next = (velocity * (1.0 - half) + felt.Force * (Period / Mass)) / (1.0 + half);
    place += 0.5 * (velocity + next) * Period;
    velocity = next;
  }
  EXPECT_LT(worst, 1e-10); // roundings of 10 N mm
}

TEST(HeldFit, PointsStandForEqualAreas)
{
  const IndexedMesh mesh = test::Ellipsoid(12, {30.0, 20.0, 10.0});
  for (const int count : {1, 12, 128, 5000})
  {
    const std::vector<Vector3> points = PointsOfEqualArea(mesh, count);
    EXPECT_NEAR(static_cast<double>(points.size()), count, 1.0);
  }
  const std::vector<Vector3> points = PointsOfEqualArea(mesh, 400);
  Vector3 mean = Vector3::Zero();
  for (const Vector3& point : points)
  {
    mean += point / 400.0;
  }
  EXPECT_LT(mean.norm(), 1.0); // of 30 mm
}

TEST(HeldFit, RefusesUnusableInput)
{
  const IndexedMesh ball = test::Sphere(3);
  HeldFit fit;
  for (HeldFitSettings bad : {HeldFitSettings{0.0, 1.0, 8}, HeldFitSettings{1.0, -1.0, 8},
                              HeldFitSettings{1.0, 1.0, 0}, HeldFitSettings{NAN, 1.0, 8}})
  {
    EXPECT_FALSE(HeldFit::Make(ball, ball, bad, fit).IsOk());
  }
  EXPECT_FALSE(HeldFit::Make({}, ball, {}, fit).IsOk());
  EXPECT_FALSE(HeldFit::Make(ball, {}, {}, fit).IsOk());
  IndexedMesh broken = ball;
  broken.Points[0].x() = NAN;
  EXPECT_FALSE(HeldFit::Make(broken, ball, {}, fit).IsOk());
  EXPECT_FALSE(HeldFit::Make(ball, broken, {}, fit).IsOk());
}
} // namespace
} // namespace palpate::held_fit_test
