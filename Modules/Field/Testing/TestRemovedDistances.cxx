#include "CutSweep.h"
#include "FieldCases.h"
#include "RemovalStroke.h"
#include "RemovedDistances.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::removed_distances_test
{
namespace
{
using Removed = std::shared_ptr<const RemovedDistances>;
constexpr double Band = 2.0; // mm

// Random strokes of a sphere in an oblique grid.
class RemovedDistancesTest : public testing::Test
{
protected:
  CutSweep RandomStroke()
  {
    std::uniform_real_distribution<double> part(-0.2, 1.2);
    const auto place = [&]
    {
      return this->Grid.PointWorld(
          Vector3(69.0 * part(this->Random), 53.0 * part(this->Random), 19.0 * part(this->Random)));
    };
    return {CutTool::Sphere(3.0), CutPose{place(), {}}, CutPose{place(), {}}, 0.25};
  }

  // One cut as a separate stroke.
  Removed Cut(const Removed& before, const CutSweep& sweep)
  {
    RemovalStroke stroke(before);
    stroke.Cut(sweep, this->Changed);
    return stroke.Finish();
  }

  template <typename Visit>
  void ForEachNode(const Visit& visit) const
  {
    for (int k = 0; k < this->Grid.Size()[2]; ++k)
    {
      for (int j = 0; j < this->Grid.Size()[1]; ++j)
      {
        for (int i = 0; i < this->Grid.Size()[0]; ++i)
        {
          visit(i, j, k);
        }
      }
    }
  }

  std::mt19937_64 Random{12};
  FieldGrid Grid = test::ObliqueGrid({{70, 54, 20}}, Random);
  std::vector<NodeBox> Changed;
};

TEST_F(RemovedDistancesTest, StartsWithNothingRemoved)
{
  const Removed none = RemovedDistances::None(this->Grid, Band);
  this->ForEachNode([&](int i, int j, int k) { ASSERT_EQ(none->At(i, j, k), float{Band}); });
}

TEST_F(RemovedDistancesTest, NodesKeepTheMinimumOverSweeps)
{
  RemovalStroke stroke(RemovedDistances::None(this->Grid, Band));
  std::vector<CutSweep> sweeps;
  for (int n = 0; n < 12; ++n)
  {
    sweeps.push_back(this->RandomStroke());
    stroke.Cut(sweeps.back(), this->Changed);
  }
  this->ForEachNode(
      [&](int i, int j, int k)
      {
        double least = Band;
        for (const CutSweep& sweep : sweeps)
        {
          least = std::min(least, sweep.Distance(this->Grid.PointWorld(Vector3(i, j, k))));
        }
        // mm; floats of paths of up to 100 mm.
        ASSERT_NEAR(stroke.Now().At(i, j, k), std::max(least, -Band), 2e-5);
      });
}

TEST_F(RemovedDistancesTest, OrderOfCutsDoesNotMatter)
{
  const CutSweep one = this->RandomStroke();
  const CutSweep two = this->RandomStroke();
  const Removed none = RemovedDistances::None(this->Grid, Band);
  const Removed a = this->Cut(this->Cut(none, one), two);
  const Removed b = this->Cut(this->Cut(none, two), one);
  this->ForEachNode([&](int i, int j, int k) { ASSERT_EQ(a->At(i, j, k), b->At(i, j, k)); });
}

TEST_F(RemovedDistancesTest, OneStrokeEqualsSeparateStrokes)
{
  Removed apart = RemovedDistances::None(this->Grid, Band);
  RemovalStroke stroke(apart);
  for (int n = 0; n < 8; ++n)
  {
    const CutSweep sweep = this->RandomStroke();
    stroke.Cut(sweep, this->Changed);
    apart = this->Cut(apart, sweep);
  }
  const Removed together = stroke.Finish();
  this->ForEachNode([&](int i, int j, int k)
                    { ASSERT_EQ(together->At(i, j, k), apart->At(i, j, k)); });
}

TEST_F(RemovedDistancesTest, SmallStepsEqualOneStroke)
{
  const Vector3 from = this->Grid.PointWorld(Vector3(15.0, 20.0, 8.0));
  const Vector3 to = this->Grid.PointWorld(Vector3(50.0, 30.0, 11.0));
  const auto pose = [&](int tick) { return CutPose{from + tick / 100.0 * (to - from), {}}; };
  const Removed none = RemovedDistances::None(this->Grid, Band);
  RemovalStroke steps(none);
  for (int tick = 0; tick < 100; ++tick)
  {
    steps.Cut({CutTool::Sphere(3.0), pose(tick), pose(tick + 1), 0.25}, this->Changed);
  }
  const Removed once = this->Cut(none, {CutTool::Sphere(3.0), pose(0), pose(100), 0.25});
  // mm; floats of some ten millimetres.
  this->ForEachNode([&](int i, int j, int k)
                    { ASSERT_NEAR(steps.Now().At(i, j, k), once->At(i, j, k), 1e-5); });
}

TEST_F(RemovedDistancesTest, HandlesAStepTooShortForFloat)
{
  const Vector3 from = this->Grid.PointWorld(Vector3(15.0, 20.0, 8.0));
  const Removed none = RemovedDistances::None(this->Grid, Band);
  const Removed still = this->Cut(none, {CutTool::Sphere(3.0), {from, {}}, {from, {}}, 0.25});
  for (const double path : {1e-25, 1e-12, 1e-7})
  {
    const CutPose to{from + Vector3::Constant(path), {}};
    const Removed moved = this->Cut(none, {CutTool::Sphere(3.0), {from, {}}, to, 0.25});
    // mm; as above.
    this->ForEachNode([&](int i, int j, int k)
                      { ASSERT_NEAR(moved->At(i, j, k), still->At(i, j, k), 1e-5); });
  }
}

TEST_F(RemovedDistancesTest, ReportsChangedNodes)
{
  Removed removed = RemovedDistances::None(this->Grid, Band);
  for (int n = 0; n < 12; ++n)
  {
    const Removed before = removed;
    removed = this->Cut(before, this->RandomStroke());
    const auto isIn = [&](int i, int j, int k)
    {
      return std::any_of(this->Changed.begin(), this->Changed.end(),
                         [&](const NodeBox& box) {
                           return !box.CommonWith({{i, j, k}, {i, j, k}}).IsEmpty();
                         });
    };
    this->ForEachNode(
        [&](int i, int j, int k)
        { ASSERT_TRUE(isIn(i, j, k) || before->At(i, j, k) == removed->At(i, j, k)); });
    std::vector<RemovedDistances::Corner> corners;
    for (const NodeBox& box : this->Changed)
    {
      corners.push_back({box.First[0] / 8 * 8, box.First[1] / 8 * 8, box.First[2] / 8 * 8});
    }
    EXPECT_EQ(RemovedDistances::Difference(*before, *removed).size(), corners.size());
  }
}

TEST_F(RemovedDistancesTest, EarlierStatesDoNotChange)
{
  const Removed first = this->Cut(RemovedDistances::None(this->Grid, Band), this->RandomStroke());
  std::vector<float> kept;
  this->ForEachNode([&](int i, int j, int k) { kept.push_back(first->At(i, j, k)); });
  Removed later = first;
  for (int n = 0; n < 6; ++n)
  {
    later = this->Cut(later, this->RandomStroke());
  }
  std::size_t node = 0;
  this->ForEachNode([&](int i, int j, int k) { ASSERT_EQ(kept[node++], first->At(i, j, k)); });
}

TEST_F(RemovedDistancesTest, CutWithoutEffectKeepsTheObject)
{
  const CutSweep stroke = this->RandomStroke();
  const Removed once = this->Cut(RemovedDistances::None(this->Grid, Band), stroke);
  EXPECT_EQ(this->Cut(once, stroke), once);
  EXPECT_TRUE(this->Changed.empty());
  const CutPose away{this->Grid.PointWorld(Vector3(500.0, 0.0, 0.0)), {}};
  EXPECT_EQ(this->Cut(once, {CutTool::Sphere(3.0), away, away, 0.25}), once);
}

TEST_F(RemovedDistancesTest, StateCostsOnlyChangedMemory)
{
  Removed before = RemovedDistances::None(this->Grid, Band);
  for (int n = 0; n < 6; ++n)
  {
    const Removed after = this->Cut(before, this->RandomStroke());
    // Blocks of 8^3 floats and two numbers, and at most all pages of pointers (two here). Blocks in
    // which only nodes beyond the grid changed are not reported.
    const std::size_t blocks =
        RemovedDistances::Difference(*before, *after).size() * (512 + 2) * sizeof(float);
    const std::size_t most = blocks + 2 * 512 * 16 + 1024;
    EXPECT_LE(after->BytesNotIn(before.get()), most);
    before = after;
  }
}
} // namespace
} // namespace palpate::removed_distances_test
