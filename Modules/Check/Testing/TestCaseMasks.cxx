#include "CaseMasks.h"
#include "CheckCases.h"
#include "InputError.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate::case_masks_test
{
namespace
{
using namespace palpate::test;

CheckedMask BallAt(double x, double radius)
{
  return MakeMask({60, 32, 32}, {1.0, 1.0, 1.0},
                  [&](const Vector3& at) { return (at - Vector3(x, 16, 16)).norm() <= radius; });
}

// Structures on layers.
CaseMasks CaseOf(std::vector<std::pair<CheckedMask, int>> given)
{
  CaseMasks masks;
  for (const auto& [mask, layer] : given)
  {
    masks.Structures.push_back({"", static_cast<int>(masks.Structures.size()) + 1, layer});
    masks.LayerCount = std::max(masks.LayerCount, static_cast<std::size_t>(layer) + 1);
  }
  masks.MaskOf = [given = std::move(given)](std::size_t n) { return given[n].first; };
  return masks;
}

double OverlapOf(const CheckedCase& patient, std::size_t n)
{
  return Find(patient.Organs[n].Measured.Statistics, "overlap").Value;
}

TEST(CaseMasks, OverlapsAreOfTheSmallerOfTwoLayers)
{
  const CheckedMask large = BallAt(20, 12);
  const CheckedMask small = BallAt(31, 7);
  double shared = 0.0;
  double own = 0.0;
  for (std::size_t v = 0; v < small.Voxels.Inside.size(); ++v)
  {
    own += small.Voxels.Inside[v];
    shared += small.Voxels.Inside[v] & large.Voxels.Inside[v];
  }
  const RadialProbe probe;
  // The first two are of one layer, whose voxels nobody counts.
  const CheckedCase patient =
      MeasureCase(CaseOf({{large, 0}, {BallAt(22, 12), 0}, {small, 1}}), probe, 2);
  EXPECT_NEAR(OverlapOf(patient, 0), shared / own, 1e-15);
  EXPECT_EQ(OverlapOf(patient, 2), OverlapOf(patient, 1)) << "the larger share";
  EXPECT_GT(OverlapOf(patient, 1), OverlapOf(patient, 0));
  EXPECT_EQ(patient.Organs[0].Name, "label 1");
}

TEST(CaseMasks, PartsOfAnOrganDoNotOverlapIt)
{
  const CheckedCase patient =
      MeasureCase(CaseOf({{BallAt(20, 12), 0}, {BallAt(22, 6), 1}}), RadialProbe(), 1);
  EXPECT_EQ(OverlapOf(patient, 0), 0.0);
  EXPECT_EQ(OverlapOf(patient, 1), 0.0);
}

TEST(CaseMasks, OneLayerHasNoOverlapsAndGridsApartNoWhole)
{
  CaseMasks masks = CaseOf({{BallAt(20, 10), 0}, {BallAt(31, 10), 0}});
  const CheckedCase together = MeasureCase(masks, RadialProbe(), 1);
  ASSERT_EQ(together.Organs.size(), 3U);
  EXPECT_TRUE(together.Organs[2].IsWhole);
  EXPECT_TRUE(std::isnan(OverlapOf(together, 0)));
  masks.AreOnOneGrid = false;
  masks.LayerCount = 2;
  const CheckedCase apart = MeasureCase(masks, RadialProbe(), 1);
  EXPECT_EQ(apart.Organs.size(), 2U);
  EXPECT_TRUE(std::isnan(OverlapOf(apart, 0)));
}

TEST(CaseMasks, RethrowsWhatMasksThrow)
{
  CaseMasks masks = CaseOf({{BallAt(20, 10), 0}});
  masks.MaskOf = [](std::size_t) -> CheckedMask { throw InputError("lost"); };
  EXPECT_THROW(MeasureCase(masks, RadialProbe(), 2), InputError);
}
} // namespace
} // namespace palpate::case_masks_test
