#include "ExaminerTable.h"
#include "ForcePerception.h"
#include "PalpatingHand.h"
#include "PalpationSearch.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace palpate::virtual_examiner_test
{
namespace
{
using namespace palpate::test;

// Coarser than for the page, for speed.
ElasticPhantom Phantom(const std::optional<HiddenNodule>& nodule)
{
  ElasticPhantom phantom;
  const Status status = ElasticPhantom::Make(nodule, 8, 8, phantom);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return phantom;
}

// Without noise: `most` newtons at a place, falling off over a few millimetres, 1 N elsewhere.
PalpationSearch::Press BumpAt(const FreePlace& place, double most)
{
  return [place, most](const FreePlace& pressed)
  { return 1.0 + (most - 1.0) * std::exp(-(pressed - place).squaredNorm() / 32.0); };
}

TEST(VirtualExaminer, RasterLeavesNoGaps)
{
  const PalpationSearch::Technique way;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-way.Reach, way.Reach);
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const std::vector<FreePlace> raster = PalpationSearch(way).Raster(seed);
    for (int i = 0; i < 200; ++i)
    {
      const FreePlace point(coordinate(random), coordinate(random));
      double nearest = std::numeric_limits<double>::infinity();
      for (const FreePlace& place : raster)
      {
        ASSERT_LE(place.norm(), way.Reach + 1e-9);
        nearest = std::min(nearest, (place - point).norm());
      }
      // Half a diagonal of the raster, away from the edge of the field.
      if (point.norm() < way.Reach - way.Spacing)
      {
        ASSERT_LE(nearest, way.Spacing / std::sqrt(2.0) + 1e-9) << seed;
      }
    }
  }
}

TEST(VirtualExaminer, ReportsFromOneJustNoticeableDifference)
{
  const PalpationSearch examiner;
  for (std::uint64_t seed = 0; seed < 10; ++seed)
  {
    const FreePlace place = examiner.Raster(seed)[seed];
    EXPECT_FALSE(examiner.Search(BumpAt(place, 1.0 + 0.068), seed)) << seed;
    // Noticed with some room, since the bump lifts the median a little.
    const auto finding = examiner.Search(BumpAt(place, 1.0 + 0.08), seed);
    ASSERT_TRUE(finding) << seed;
    EXPECT_EQ(finding->Place, place);
    EXPECT_NEAR(finding->Contrast, 0.08 / 0.07, 0.1);
  }
}

TEST(VirtualExaminer, IgnoresSofterPlacesAndEvenOrgans)
{
  const PalpationSearch examiner;
  EXPECT_FALSE(examiner.Search(BumpAt({3.0, 2.0}, 0.5), 1));
  EXPECT_FALSE(examiner.Search(BumpAt({3.0, 2.0}, 1.0), 1));
}

TEST(VirtualExaminer, PressesEachPlaceAndComesBackToSuspects)
{
  const PalpationSearch::Technique way;
  const PalpationSearch examiner(way);
  std::vector<FreePlace> pressed;
  const PalpationSearch::Press bump = BumpAt({3.0, 2.0}, 1.5);
  const auto finding = examiner.Search(
      [&](const FreePlace& place)
      {
        pressed.push_back(place);
        return bump(place);
      },
      5);
  ASSERT_TRUE(finding);
  const auto places = static_cast<std::ptrdiff_t>(examiner.Raster(5).size());
  EXPECT_EQ(static_cast<std::ptrdiff_t>(pressed.size()),
            places * way.Sweeps + way.Suspects * way.Returns);
  EXPECT_EQ(std::count(pressed.begin(), pressed.end(), finding->Place), way.Sweeps + way.Returns);
}

TEST(PalpatingHand, ErrsAsStated)
{
  const ElasticPhantom phantom = Phantom(std::nullopt);
  PalpatingHand hand(phantom, 7);
  constexpr int Presses = 4000;
  double sum = 0.0;
  double squares = 0.0;
  const FreePlace place(2.0, 1.0);
  const double force = phantom.Force(place, PalpatingHand::Depth);
  for (int i = 0; i < Presses; ++i)
  {
    const double error = hand.Press(place) - force;
    sum += error;
    squares += error * error;
  }
  // The percept's error, and that of the depth through the slope of the force. The organ is even
  // there, so errors of the place hardly count.
  const double step = 0.01;
  const double slope = (phantom.Force(place, PalpatingHand::Depth + step) -
                        phantom.Force(place, PalpatingHand::Depth - step)) /
                       (2.0 * step);
  const double deviation =
      std::hypot(PalpatingHand::PerceptDeviation * ForcePerception::JustNoticeable(force),
                 PalpatingHand::DepthDeviation * slope);
  EXPECT_NEAR(sum / Presses, 0.0, 5.0 * deviation / std::sqrt(Presses));
  EXPECT_NEAR(std::sqrt(squares / Presses), deviation, 5.0 * deviation / std::sqrt(2.0 * Presses));
}

TEST(ElasticPhantom, FeelsEvenWithoutNoduleAndHarderAboveOne)
{
  const ElasticPhantom plain = Phantom(std::nullopt);
  const ElasticPhantom hard = Phantom(HiddenNodule{12.0, 2.0, 5.0});
  const double usual = plain.Force(FreePlace::Zero(), PalpatingHand::Depth);
  for (const FreePlace& place : PalpationSearch().Raster(1))
  {
    // Less than half of what is reported.
    EXPECT_LE(std::abs(ForcePerception::Contrast(plain.Force(place, PalpatingHand::Depth), usual)),
              0.5);
  }
  EXPECT_GT(hard.Force(ElasticPhantom::NodulePlace, PalpatingHand::Depth), 1.3 * usual);
}

TEST(ExaminerTable, SameSeedGivesSameResult)
{
  const ElasticPhantom plain = Phantom(std::nullopt);
  const ElasticPhantom phantom = Phantom(HiddenNodule{8.0, 2.0, 2.5});
  const ExaminerRow first = SearchPhantom(phantom, plain, 60, 1);
  const ExaminerRow again = SearchPhantom(phantom, plain, 60, 1);
  EXPECT_EQ(again.Found, first.Found);
  EXPECT_EQ(again.Elsewhere, first.Elsewhere);
  PalpatingHand hand(phantom, 1);
  PalpatingHand same(phantom, 1);
  PalpatingHand other(phantom, 2);
  const double felt = hand.Press({1.0, 2.0});
  EXPECT_EQ(same.Press({1.0, 2.0}), felt);
  EXPECT_NE(other.Press({1.0, 2.0}), felt);
}

TEST(ExaminerTable, ObviousNoduleIsFound)
{
  const ExaminerRow row =
      SearchPhantom(Phantom(HiddenNodule{16.0, 2.0, 10.0}), Phantom(std::nullopt), 200);
  EXPECT_GE(row.Found, 190);
}

TEST(ExaminerTable, FalseAlarmsAreRare)
{
  const ElasticPhantom plain = Phantom(std::nullopt);
  const ExaminerRow row = SearchPhantom(plain, plain, 400);
  EXPECT_EQ(row.Found, 0);
  EXPECT_LE(row.Elsewhere, 20); // 5 %
}

TEST(ExaminerTable, MoreContrastIsNotFoundLess)
{
  const ElasticPhantom plain = Phantom(std::nullopt);
  constexpr int Searches = 200;
  int before = 0;
  double contrast = 0.0;
  for (const double ratio : {1.4, 2.5, 5.0, 10.0})
  {
    const ExaminerRow row = SearchPhantom(Phantom(HiddenNodule{8.0, 2.0, ratio}), plain, Searches);
    EXPECT_GT(row.Contrast, contrast) << ratio;
    // The same errors of the hand in every phantom, so few searches get lost.
    EXPECT_GE(row.Found, before - Searches / 20) << ratio;
    before = row.Found;
    contrast = row.Contrast;
  }
  EXPECT_GT(before, Searches / 2);
}
} // namespace
} // namespace palpate::virtual_examiner_test
