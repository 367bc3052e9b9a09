#include "FieldGrid.h"

#include "RandomOrientation.h"
#include "WorstCase.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::field_grid_test
{
namespace
{
FieldGrid Oblique(std::mt19937_64& random)
{
  return {{40, 50, 12}, {-120.0, 33.0, 250.0}, {0.4, 0.9, 5.0}, test::RandomOrientation(random)};
}

TEST(FieldGrid, WorldIsOriginPlusDirectionTimesSpacingTimesIndex)
{
  std::mt19937_64 random(1);
  const FieldGrid grid = Oblique(random);
  const Vector3 index(3.25, 7.5, 11.0);
  Vector3 expected = grid.OriginWorld();
  for (int axis = 0; axis < 3; ++axis)
  {
    expected += grid.Direction().col(axis) * grid.Spacing()[axis] * index[axis];
  }
  EXPECT_LE((grid.PointWorld(index) - expected).norm(), 1e-13); // roundings of some 100 mm
}

TEST(FieldGrid, RoundTripIsExactToRounding)
{
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> place(-200.0, 300.0);
  for (int round = 0; round < 1000; ++round)
  {
    const FieldGrid grid = Oblique(random);
    const Vector3 world(place(random), place(random), place(random));
    const Vector3 back = grid.PointWorld(grid.PointIndex(world));
    ASSERT_LE((back - world).norm(), 5e-12); // some twenty roundings of numbers up to 550 mm
  }
}

TEST(FieldGrid, GradientsKeepDirectionalDerivatives)
{
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  test::WorstCase worst;
  for (int round = 0; round < 200; ++round)
  {
    const FieldGrid grid = Oblique(random);
    const Vector3 gradient(normal(random), normal(random), normal(random));
    const Vector3 step(normal(random), normal(random), normal(random));
    worst.Add(grid.GradientWorld(gradient).dot(grid.VectorWorld(step)) - gradient.dot(step));
  }
  EXPECT_LE(worst.Value(), 1e-13); // a dozen roundings of numbers up to 30
}

TEST(FieldGrid, RejectsInvalidGrids)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3 zero = Vector3::Zero();
  const Vector3 one = Vector3::Ones();
  const Matrix3 identity = Matrix3::Identity();
  EXPECT_TRUE(FieldGrid({2, 2, 2}, zero, one, identity).Check().IsOk());
  EXPECT_FALSE(FieldGrid({5, 5, 1}, zero, one, identity).Check().IsOk());
  EXPECT_FALSE(FieldGrid({0, 5, 5}, zero, one, identity).Check().IsOk());
  EXPECT_FALSE(FieldGrid({5, 5, 1 << 20}, zero, one, identity).Check().IsOk());
  EXPECT_FALSE(FieldGrid({5, 5, 5}, {0, nan, 0}, one, identity).Check().IsOk());
  for (const double spacing : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()})
  {
    EXPECT_FALSE(FieldGrid({5, 5, 5}, zero, {1, 1, spacing}, identity).Check().IsOk()) << spacing;
  }
  EXPECT_FALSE(FieldGrid({5, 5, 5}, zero, one, -identity).Check().IsOk());
  EXPECT_FALSE(FieldGrid({5, 5, 5}, zero, one, 2.0 * identity).Check().IsOk());
  EXPECT_FALSE(FieldGrid({5, 5, 5}, zero, one, nan * identity).Check().IsOk());
}
} // namespace
} // namespace palpate::field_grid_test
