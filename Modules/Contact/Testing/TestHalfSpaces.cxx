#include "HalfSpaces.h"

#include "RandomShapes.h"
#include "SingularValues.h"
#include "WorstCase.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace palpate::half_spaces_test
{
namespace
{
using test::Random;
using test::RandomDirection;

// Of coordinates up to 10 where planes meet at angles down to some hundredths.
constexpr double Rounding = 1e-9;

bool AreHeld(const Vector3& point, const std::vector<HalfSpace>& spaces)
{
  for (const HalfSpace& space : spaces)
  {
    if (space.Normal.dot(point) < space.Offset - Rounding)
    {
      return false;
    }
  }
  return true;
}

// Brute force: the nearest allowed point among the projections on all planes, lines and corners.
bool NearestByTrial(const Vector3& goal, const std::vector<HalfSpace>& spaces, Vector3& nearest)
{
  std::vector<Vector3> trials{goal};
  const auto solve = [&](const std::vector<std::size_t>& chosen)
  {
    Matrix3 normals = Matrix3::Zero();
    Vector3 missing = Vector3::Zero();
    for (std::size_t row = 0; row < chosen.size(); ++row)
    {
      const auto r = static_cast<Eigen::Index>(row);
      normals.row(r) = spaces[chosen[row]].Normal.transpose();
      missing[r] = spaces[chosen[row]].Offset - spaces[chosen[row]].Normal.dot(goal);
    }
    // The shortest step, of lengths along the normals' singular directions.
    const SingularValues parts = SingularValuesOf(normals);
    Vector3 lengths = parts.Left.transpose() * missing;
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      const bool isFree = parts.Values[i] < 1e-12; // normals are unit vectors: rounding
      lengths[i] = isFree ? 0.0 : lengths[i] / parts.Values[i];
    }
    trials.push_back(goal + parts.Right * lengths);
  };
  for (std::size_t i = 0; i < spaces.size(); ++i)
  {
    solve({i});
    for (std::size_t j = 0; j < i; ++j)
    {
      solve({i, j});
      for (std::size_t k = 0; k < j; ++k)
      {
        solve({i, j, k});
      }
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3& trial : trials)
  {
    if ((trial - goal).norm() < least && AreHeld(trial, spaces))
    {
      least = (trial - goal).norm();
      nearest = trial;
    }
  }
  return least < std::numeric_limits<double>::infinity();
}

TEST(HalfSpaces, NearestPointEqualsBruteForce)
{
  Random random(5101);
  test::WorstCase error;
  int held = 0;
  for (int sample = 0; sample < 3000; ++sample)
  {
    const std::size_t count = random() % 7;
    std::vector<HalfSpace> spaces;
    for (std::size_t i = 0; i < count; ++i)
    {
      std::normal_distribution<double> offset;
      spaces.push_back({RandomDirection(random), offset(random)});
    }
    const Vector3 goal = RandomDirection(random);
    Vector3 expected = Vector3::Zero();
    const bool isHeld = NearestByTrial(goal, spaces, expected);
    const NearestHeld nearest = NearestInHalfSpaces(goal, spaces.data(), count);
    ASSERT_EQ(nearest.IsHeld, isHeld) << sample;
    if (isHeld)
    {
      ++held;
      // Distant corners belong to nearly parallel planes, and are less accurate accordingly.
      error.Add((nearest.Point - expected).norm() / (1.0 + expected.squaredNorm()));
    }
  }
  EXPECT_GT(held, 2000);
  EXPECT_LT(held, 3000);
  EXPECT_LE(error.Value(), Rounding);
}

TEST(HalfSpaces, DuplicatePlanesChangeNothing)
{
  Random random(5102);
  for (int sample = 0; sample < 200; ++sample)
  {
    std::vector<HalfSpace> spaces;
    for (int i = 0; i < 3; ++i)
    {
      spaces.push_back({(Vector3::UnitZ() + RandomDirection(random)).normalized(), 1.0});
    }
    const Vector3 goal = RandomDirection(random);
    const NearestHeld once = NearestInHalfSpaces(goal, spaces.data(), spaces.size());
    spaces.insert(spaces.end(), spaces.begin(), spaces.begin() + 3);
    const NearestHeld twice = NearestInHalfSpaces(goal, spaces.data(), spaces.size());
    EXPECT_EQ(once.IsHeld, twice.IsHeld);
    EXPECT_LE((once.Point - twice.Point).norm(), Rounding * (1.0 + once.Point.norm()));
  }
}

TEST(HalfSpaces, OppositePlanesAllowOnlyTheGapBetweenThem)
{
  const std::vector<HalfSpace> slab{{Vector3::UnitX(), 1.0}, {-Vector3::UnitX(), -2.0}};
  const NearestHeld inside = NearestInHalfSpaces(Vector3(5.0, 3.0, 0.0), slab.data(), 2);
  EXPECT_TRUE(inside.IsHeld);
  EXPECT_LE((inside.Point - Vector3(2.0, 3.0, 0.0)).norm(), Rounding);
  const std::vector<HalfSpace> nothing{{Vector3::UnitX(), 2.0}, {-Vector3::UnitX(), -1.0}};
  EXPECT_FALSE(NearestInHalfSpaces(Vector3(5.0, 3.0, 0.0), nothing.data(), 2).IsHeld);
}

TEST(HalfSpaces, IsIndependentOfTheUnitOfLength)
{
  Random random(5103);
  for (int sample = 0; sample < 200; ++sample)
  {
    std::vector<HalfSpace> spaces;
    for (int i = 0; i < 4; ++i)
    {
      spaces.push_back({(Vector3::UnitZ() + RandomDirection(random)).normalized(), 0.5});
    }
    const Vector3 goal = RandomDirection(random);
    const NearestHeld one = NearestInHalfSpaces(goal, spaces.data(), spaces.size());
    const double scale = 0x1p-30; // a power of two changes no digit
    for (HalfSpace& space : spaces)
    {
      space.Offset *= scale;
    }
    const NearestHeld other = NearestInHalfSpaces(scale * goal, spaces.data(), spaces.size());
    EXPECT_EQ(one.IsHeld, other.IsHeld);
    EXPECT_EQ(Vector3(scale * one.Point), other.Point);
  }
}
} // namespace
} // namespace palpate::half_spaces_test
