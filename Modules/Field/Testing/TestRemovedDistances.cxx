#include "CutSweep.h"
#include "FieldCases.h"
#include "RemovedDistances.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate
{
namespace
{
using Removed = std::shared_ptr<const RemovedDistances>;
constexpr double Band = 2.0; // mm

// Strokes of a ball here and there in an oblique grid.
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
  std::vector<RemovedDistances::Corner> Changed;
};

TEST_F(RemovedDistancesTest, NothingIsRemovedAtFirst)
{
  const Removed none = RemovedDistances::None(this->Grid, Band);
  this->ForEachNode([&](int i, int j, int k) { ASSERT_EQ(none->At(i, j, k), float{Band}); });
}

TEST_F(RemovedDistancesTest, EveryNodeKeepsTheLeastOfAllSweeps)
{
  Removed removed = RemovedDistances::None(this->Grid, Band);
  std::vector<CutSweep> sweeps;
  for (int n = 0; n < 12; ++n)
  {
    sweeps.push_back(this->RandomStroke());
    removed = RemovedDistances::Cut(removed, sweeps.back(), this->Changed);
  }
  this->ForEachNode(
      [&](int i, int j, int k)
      {
        double least = Band;
        for (const CutSweep& sweep : sweeps)
        {
          least = std::min(least, sweep.Distance(this->Grid.PointWorld(Vector3(i, j, k))));
        }
        ASSERT_EQ(removed->At(i, j, k), static_cast<float>(std::max(least, -Band)));
      });
}

TEST_F(RemovedDistancesTest, TheOrderOfCutsDoesNotMatter)
{
  const CutSweep one = this->RandomStroke();
  const CutSweep two = this->RandomStroke();
  const Removed none = RemovedDistances::None(this->Grid, Band);
  const Removed a =
      RemovedDistances::Cut(RemovedDistances::Cut(none, one, this->Changed), two, this->Changed);
  const Removed b =
      RemovedDistances::Cut(RemovedDistances::Cut(none, two, this->Changed), one, this->Changed);
  this->ForEachNode([&](int i, int j, int k) { ASSERT_EQ(a->At(i, j, k), b->At(i, j, k)); });
}

TEST_F(RemovedDistancesTest, AStrokeInSmallStepsIsTheStrokeAtOnce)
{
  const Vector3 from = this->Grid.PointWorld(Vector3(15.0, 20.0, 8.0));
  const Vector3 to = this->Grid.PointWorld(Vector3(50.0, 30.0, 11.0));
  const auto pose = [&](int tick) { return CutPose{from + tick / 100.0 * (to - from), {}}; };
  const Removed none = RemovedDistances::None(this->Grid, Band);
  Removed steps = none;
  for (int tick = 0; tick < 100; ++tick)
  {
    steps = RemovedDistances::Cut(steps, {CutTool::Sphere(3.0), pose(tick), pose(tick + 1), 0.25},
                                  this->Changed);
  }
  const Removed once =
      RemovedDistances::Cut(none, {CutTool::Sphere(3.0), pose(0), pose(100), 0.25}, this->Changed);
  // mm; floats of some millimetres, and rounding of a way's part.
  this->ForEachNode([&](int i, int j, int k)
                    { ASSERT_NEAR(steps->At(i, j, k), once->At(i, j, k), 1e-6); });
}

TEST_F(RemovedDistancesTest, ChangedBlocksAreThoseThatDiffer)
{
  Removed removed = RemovedDistances::None(this->Grid, Band);
  for (int n = 0; n < 12; ++n)
  {
    const Removed before = removed;
    removed = RemovedDistances::Cut(before, this->RandomStroke(), this->Changed);
    std::vector<RemovedDistances::Corner> differing =
        RemovedDistances::Difference(*before, *removed);
    std::sort(differing.begin(), differing.end());
    std::sort(this->Changed.begin(), this->Changed.end());
    EXPECT_EQ(differing, this->Changed);
    this->ForEachNode(
        [&](int i, int j, int k)
        {
          const RemovedDistances::Corner corner{i / 8 * 8, j / 8 * 8, k / 8 * 8};
          const bool isIn = std::binary_search(this->Changed.begin(), this->Changed.end(), corner);
          ASSERT_TRUE(isIn || before->At(i, j, k) == removed->At(i, j, k));
        });
  }
}

TEST_F(RemovedDistancesTest, EarlierStatesStayAsTheyWere)
{
  const Removed first = RemovedDistances::Cut(RemovedDistances::None(this->Grid, Band),
                                              this->RandomStroke(), this->Changed);
  std::vector<float> kept;
  this->ForEachNode([&](int i, int j, int k) { kept.push_back(first->At(i, j, k)); });
  Removed later = first;
  for (int n = 0; n < 6; ++n)
  {
    later = RemovedDistances::Cut(later, this->RandomStroke(), this->Changed);
  }
  std::size_t node = 0;
  this->ForEachNode([&](int i, int j, int k) { ASSERT_EQ(kept[node++], first->At(i, j, k)); });
}

TEST_F(RemovedDistancesTest, ACutThatRemovesNothingNewIsTheSameObject)
{
  const CutSweep stroke = this->RandomStroke();
  const Removed once =
      RemovedDistances::Cut(RemovedDistances::None(this->Grid, Band), stroke, this->Changed);
  EXPECT_EQ(RemovedDistances::Cut(once, stroke, this->Changed), once);
  EXPECT_TRUE(this->Changed.empty());
  const CutPose away{this->Grid.PointWorld(Vector3(500.0, 0.0, 0.0)), {}};
  EXPECT_EQ(RemovedDistances::Cut(once, {CutTool::Sphere(3.0), away, away, 0.25}, this->Changed),
            once);
}

TEST_F(RemovedDistancesTest, AStateTakesTheMemoryOfWhatChanged)
{
  Removed before = RemovedDistances::None(this->Grid, Band);
  for (int n = 0; n < 6; ++n)
  {
    const Removed after = RemovedDistances::Cut(before, this->RandomStroke(), this->Changed);
    // Blocks of 8^3 floats and one number, and at most all pages of pointers (of two here).
    const std::size_t blocks = this->Changed.size() * (512 + 1) * sizeof(float);
    const std::size_t most = blocks + 2 * 512 * 16 + 1024;
    EXPECT_LE(after->BytesBeside(before.get()), most);
    before = after;
  }
}
} // namespace
} // namespace palpate
