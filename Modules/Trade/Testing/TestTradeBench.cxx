#include "TradeBench.h"

#include "FilterRun.h"
#include "IcosahedronDirections.h"
#include "InputError.h"
#include "TradeCases.h"
#include "TradeErrors.h"
#include "TradeMeasure.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate
{
namespace
{
using test::GoOn;

TradeRow Measure(TradeBench& bench, const TradeSetting& setting)
{
  return bench.Measure({setting, TradeKnob::Representation}, GoOn);
}

TEST(TradeBench, AWholeModelIsTrue)
{
  const test::StillClock clock;
  TradeBench bench(test::BumpyModel(0.5), test::ShortPath(), clock);
  const TradeRow row = Measure(bench, test::Harmonics(6));
  // What the tracker's own tolerance allows (Documentation/Touch.md).
  EXPECT_LT(row.PositionMost, 1e-5);
  EXPECT_LT(row.DirectionMost, 1e-3);
  EXPECT_EQ(row.Seizures, 0.0);
  EXPECT_GT(row.Bytes, 0.0);
}

TEST(TradeBench, ALowerDegreeIsWrongByWhatItLeavesOut)
{
  constexpr double Height = 0.5; // mm
  const test::StillClock clock;
  TradeBench bench(test::BumpyModel(Height), test::ShortPath(), clock);
  const TradeRow row = Measure(bench, test::Harmonics(5));
  // The bumps lie between 0.5 mm above the ball at the poles and 0.21 below; between, they change
  // sign. A ball of 2 mm feels their tops as they are.
  EXPECT_LE(row.SurfaceMost, Height * 1.001);
  EXPECT_GT(row.SurfaceMost, 0.2 * Height);
}

TEST(TradeBench, FacetsOfABallAreWrongByTheirSagitta)
{
  constexpr int Frequency = 5;
  const test::StillClock clock;
  TradeBench::Settings settings = test::ShortPath();
  settings.Tool.Radius = 0.0; // a point meets the middles of facets
  TradeBench bench(test::BumpyModel(0.0), settings, clock);
  const TradeRow row = Measure(bench, test::Facets(20 * Frequency * Frequency));
  double sagitta = 0.0;
  const IcosahedronDirections sphere(Frequency);
  for (const auto& [a, b, c] : sphere.Triangles())
  {
    const auto corner = [&](int n) { return sphere.Directions()[static_cast<std::size_t>(n)]; };
    const Vector3 normal = (corner(b) - corner(a)).cross(corner(c) - corner(a)).normalized();
    sagitta = std::max(sagitta, test::BallRadius * (1.0 - std::abs(normal.dot(corner(a)))));
  }
  // At a true place of contact the facet lies at most its sagitta below; where the probe is deep
  // the nearest place on the facets is a little aside, and nearer to a corner.
  EXPECT_LE(row.SurfaceMost, 1.05 * sagitta);
  EXPECT_GT(row.SurfaceMost, 0.8 * sagitta) << "two seconds of sliding meet a facet's middle";
}

TEST(TradeBench, AReferenceComparedWithItselfIsTrueToRounding)
{
  constexpr int Points = 400; // as the reference has them
  const test::StillClock clock;
  TradeBench bench(test::BallMask(), test::ShortPath(), clock);
  const TradeRow row = Measure(bench, test::SubVoxel(FieldInterpolation::TricubicBSpline, Points));
  EXPECT_LT(row.PositionMost, 1e-12);
  EXPECT_NE(row.Truth.find("tricubic"), std::string::npos);
}

TEST(TradeBench, FewerPointsOfAToolThatIsNoSphereAreLessTrue)
{
  const test::StillClock clock;
  TradeBench::Settings settings = test::ShortPath();
  settings.Tool.Kind = TouchToolSettings::Shape::Ellipsoid; // 4, 2, 2 mm
  TradeBench bench(test::BallMask(), settings, clock);
  const TradeRow few = Measure(bench, test::SubVoxel(FieldInterpolation::TricubicBSpline, 26));
  const TradeRow more = Measure(bench, test::SubVoxel(FieldInterpolation::TricubicBSpline, 200));
  // Between points an angle of a apart a ball of r lies up to r (1 - cos(a / 2)) higher; a falls
  // with the root of their number, so the error with the number, 7.7 times here.
  EXPECT_GT(few.PositionMean, 3.0 * more.PositionMean);
  EXPECT_LT(more.PositionMean, 0.1);
}

TEST(TradeBench, TheSameSeedGivesTheSameRowToTheBit)
{
  const test::StillClock clock;
  const auto measure = [&clock](std::uint64_t seed)
  {
    TradeBench bench(test::BallMask(), test::ShortPath(seed), clock);
    return Measure(bench, test::SubVoxel(FieldInterpolation::Trilinear, 26));
  };
  const TradeRow first = measure(7);
  const TradeRow again = measure(7);
  EXPECT_EQ(first.PositionMean, again.PositionMean);
  EXPECT_EQ(first.DirectionMost, again.DirectionMost);
  EXPECT_EQ(first.JumpMean, again.JumpMean);
  EXPECT_NE(first.PositionMean, measure(8).PositionMean);
}

TEST(TradeBench, WhatCannotBeRepresentedIsARowThatSaysSo)
{
  const test::StillClock clock;
  const auto isHorseshoe = [](double x, double y, double z)
  { return std::hypot(std::hypot(x, y) - 11.0, z) < 4.0 && (x < 8.0 || y < 0.0); };
  TradeBench bench(test::MaskOf(isHorseshoe), test::ShortPath(), clock);
  const TradeRow row = Measure(bench, test::Harmonics(8));
  EXPECT_EQ(row.State, TradeRow::Outcome::Refused);
  EXPECT_NE(row.Message.find("star-shaped"), std::string::npos) << row.Message;
  EXPECT_TRUE(std::isnan(row.PositionMean));
  EXPECT_EQ(Measure(bench, test::Facets(500)).State, TradeRow::Outcome::Measured);
}

TEST(TradeBench, EveryCandidateOfAMaskCanBeMeasured)
{
  const test::StillClock clock;
  TradeBench bench(test::BallMask(), test::ShortPath(), clock);
  const std::vector<TradeCandidate> candidates = bench.Candidates(GoOn);
  EXPECT_GT(candidates.size(), 15U);
  for (const TradeRow& row : MeasureTrade(bench, candidates, GoOn))
  {
    EXPECT_EQ(row.State, TradeRow::Outcome::Measured) << Describe(row.Setting) << row.Message;
    const double error = row.IsFelt() ? row.PositionRare : row.DrawMost;
    EXPECT_LT(error, 2.0) << Describe(row.Setting);
  }
}

TEST(TradeBench, CandidatesAreAllDifferent)
{
  const test::StillClock clock;
  TradeBench bench(test::BallMask(), test::ShortPath(), clock);
  std::set<std::string> keys;
  for (const TradeCandidate& candidate : bench.Candidates(GoOn))
  {
    EXPECT_TRUE(keys.insert(KeyOf(candidate.Setting)).second) << KeyOf(candidate.Setting);
  }
}

TEST(TradeBench, ATableOfOneKnobHasTheDefaultsAndThat)
{
  const test::StillClock clock;
  TradeBench bench(test::BallMask(), test::ShortPath(), clock);
  const auto chosen = Only(bench.Candidates(GoOn), {TradeKnob::Degree});
  EXPECT_TRUE(std::all_of(chosen.begin(), chosen.end(),
                          [](const TradeCandidate& one) {
                            return one.Knob == TradeKnob::Degree ||
                                   one.Knob == TradeKnob::Representation;
                          }));
  EXPECT_GT(chosen.size(), 4U);
}

TEST(TradeBench, MoreTrianglesDrawAModelCloser)
{
  const test::StillClock clock;
  TradeBench bench(test::BumpyModel(0.5), test::ShortPath(), clock);
  TradeSetting setting = test::Harmonics(6);
  setting.DrawnFrequency = 5;
  const TradeRow coarse = Measure(bench, setting);
  setting.DrawnFrequency = 20;
  const TradeRow fine = Measure(bench, setting);
  EXPECT_EQ(fine.Triangles, 8000.0);
  // Sagittas fall with the square of the edge: 16; a little less where facets differ in size.
  EXPECT_GT(coarse.DrawMost, 12.0 * fine.DrawMost);
  EXPECT_FALSE(fine.IsFelt());
}

TEST(TradeBench, AToolThatCannotTouchAModelIsRefused)
{
  const test::StillClock clock;
  TradeBench::Settings settings = test::ShortPath();
  settings.Tool.Kind = TouchToolSettings::Shape::Ellipsoid;
  TradeBench bench(test::BumpyModel(0.5), settings, clock);
  EXPECT_THROW(Measure(bench, test::Harmonics(6)), InputError);
}

TEST(TradeBench, CanBeCancelled)
{
  const test::StillClock clock;
  TradeBench bench(test::BallMask(), test::ShortPath(), clock);
  const auto stop = [](double /*fraction*/, const std::string& stage) { return stage != "touch"; };
  EXPECT_THROW(
      bench.Measure({test::SubVoxel(FieldInterpolation::Trilinear, 26), TradeKnob::Representation},
                    stop),
      Cancelled);
  EXPECT_EQ(Measure(bench, test::SubVoxel(FieldInterpolation::Trilinear, 26)).State,
            TradeRow::Outcome::Measured)
      << "and goes on after that";
}

TEST(TradePath, BeginsEachStrokeFreeAndGoesNoDeeperThanItSays)
{
  const test::StillClock clock;
  TradeBench bench(test::BumpyModel(0.5), test::ShortPath(), clock);
  const TradePath& path = bench.Path(GoOn);
  ASSERT_GT(path.Strokes.size(), 2U);
  for (const std::size_t first : path.Strokes)
  {
    EXPECT_FALSE(path.Ticks[first].Truth.IsTouching);
  }
  double deepest = 0.0;
  std::size_t touching = 0;
  for (const TradePath::Tick& tick : path.Ticks)
  {
    ASSERT_TRUE(tick.Truth.IsKnown);
    deepest = std::max(deepest, (tick.Truth.ProxyWorld - tick.ProbeWorld).norm());
    touching += tick.Truth.IsTouching ? 1 : 0;
  }
  // The way from one proxy's aim to the next adds up to a step of 0.2 mm.
  EXPECT_LT(deepest, path.MostDepth + 0.2);
  EXPECT_GT(deepest, 0.5 * path.MostDepth);
  EXPECT_GT(touching, path.Ticks.size() / 2);
}

TEST(TradeErrors, AForceThatIsNoNumberLeavesNoNumber)
{
  const test::StillClock clock;
  TradeBench bench(test::BumpyModel(0.5), test::ShortPath(), clock);
  const TradePath& path = bench.Path(GoOn);
  std::vector<FeltTick> felt(path.Ticks.size());
  const auto touched =
      std::find_if(path.Ticks.begin(), path.Ticks.end(),
                   [](const TradePath::Tick& tick) { return tick.Truth.IsTouching; });
  felt[static_cast<std::size_t>(touched - path.Ticks.begin())] = {true, Vector3::Constant(NAN)};
  TradeRow row;
  CompareWithTruth(path, felt, 0.5, row);
  EXPECT_TRUE(std::isnan(row.PositionMost));
  EXPECT_TRUE(std::isnan(row.PositionRare));
  EXPECT_GE(row.Seizures, 1.0);
}

TEST(TradeErrors, AForceThatIsATenthTooStrongIsThatMuch)
{
  const test::StillClock clock;
  TradeBench bench(test::BumpyModel(0.5), test::ShortPath(), clock);
  const TradePath& path = bench.Path(GoOn);
  constexpr double Stiffness = 0.5; // N/mm
  std::vector<FeltTick> felt;
  for (const TradePath::Tick& tick : path.Ticks)
  {
    felt.push_back(
        {tick.Truth.IsTouching, 1.1 * Stiffness * (tick.Truth.ProxyWorld - tick.ProbeWorld)});
  }
  TradeRow row;
  CompareWithTruth(path, felt, Stiffness, row);
  // A tenth in parts of 7 %, where the force is half a newton or more; less below.
  EXPECT_NEAR(row.NoticeableRare, 0.1 / 0.07, 1e-9);
  EXPECT_LT(row.NoticeableMean, 0.1 / 0.07);
  EXPECT_LT(row.DirectionMost, 1e-5);
  EXPECT_NEAR(row.JumpMean, 1.1 * row.IdealJumpMean, 1e-12);
  EXPECT_NEAR(row.PositionMean * Stiffness, row.ForceMean, 1e-12);
}

TEST(TradeMeasure, ATicksTimeIsWhatTheClockSaysLessTheClocksOwn)
{
  // On it only glances take time.
  class GlanceClock final : public Clock
  {
  public:
    std::int64_t Now() const noexcept override { return this->Time += 100; }
    void WaitUntil(std::int64_t time) noexcept override { this->Time = time; }

  private:
    mutable std::int64_t Time = 0;
  };
  const GlanceClock clock;
  TradeBench bench(test::BumpyModel(0.5), test::ShortPath(), clock);
  const TradeRow row = Measure(bench, test::Harmonics(6));
  // Less than a nanosecond is not told.
  EXPECT_EQ(row.TickMedian, 1.0);
  EXPECT_EQ(row.TickLongest, 1.0);
  EXPECT_DOUBLE_EQ(row.Rate, 1e9);
}
} // namespace
} // namespace palpate
