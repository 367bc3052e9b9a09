#include "StructureTrade.h"

#include "IcosahedronDirections.h"
#include "InputError.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "Progress.h"
#include "SurfacePhantoms.h"
#include "TradeCases.h"
#include "TradeErrors.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace palpate::structure_trade_test
{
namespace
{
using test::GoOn;

TEST(TradeMeasure, WholeModelEqualsTheReference)
{
  const TradeRow row = test::ModelTrade(0.5).MeasureDegree(6);
  // The tracker's own tolerance (Documentation/Evidence/Touch.md).
  EXPECT_LT(row.PositionMost, 1e-5);
  EXPECT_LT(row.DirectionMost, 1e-3);
  EXPECT_EQ(row.Seizures, 0.0);
  EXPECT_GT(row.Bytes, 0.0);
}

TEST(TradeMeasure, LowerDegreeErrsByTheOmittedShape)
{
  constexpr double Height = 0.5; // mm
  const TradeRow row = test::ModelTrade(Height).MeasureDegree(5);
  // The bumps lie between 0.5 mm above the sphere at the poles and 0.21 below; between, they change
  // sign. A sphere of 2 mm touches their tops exactly.
  EXPECT_LE(row.SurfaceMost, Height * 1.001);
  EXPECT_GT(row.SurfaceMost, 0.2 * Height);
}

TEST(TradeMeasure, FacetsOfASphereErrByTheirSagitta)
{
  constexpr int Frequency = 5;
  const test::ModelTrade trade(0.0, 0.0); // a point touches facet centres
  const TradeRow row =
      trade.Measure(MakeFacetContact(DrawModel(*trade.Model, Frequency), "bumpy.vtp"));
  double sagitta = 0.0;
  const IcosahedronDirections sphere(Frequency);
  for (const auto& [a, b, c] : sphere.Triangles())
  {
    const auto corner = [&](int n) { return sphere.Directions()[static_cast<std::size_t>(n)]; };
    const Vector3 normal = (corner(b) - corner(a)).cross(corner(c) - corner(a)).normalized();
    sagitta = std::max(sagitta, test::SphereRadius * (1.0 - std::abs(normal.dot(corner(a)))));
  }
  // At the reference contact the facet lies at most its sagitta below; for a deep probe the nearest
  // point on the facets is slightly displaced towards a corner.
  EXPECT_LE(row.SurfaceMost, 1.05 * sagitta);
  EXPECT_GT(row.SurfaceMost, 0.8 * sagitta) << "two seconds of sliding pass over a facet's centre";
}

TEST(TradeMeasure, TickTimeExcludesTheClocksOverhead)
{
  // Only reading the clock takes time.
  class GlanceClock final : public Clock
  {
  public:
    std::int64_t Now() const noexcept override { return this->Time += 100; }
    void WaitUntil(std::int64_t time) noexcept override { this->Time = time; }

  private:
    mutable std::int64_t Time = 0;
  };
  const test::ModelTrade trade(0.5);
  const TradeRow row =
      trade.Measure(MakeModelContact(*trade.Model, RadialContactMode::Nearest, {}), GlanceClock());
  // Times are at least a nanosecond.
  EXPECT_EQ(row.TickMedian, 1.0);
  EXPECT_DOUBLE_EQ(row.Rate, 1e9);
}

TEST(StructureTrade, ReferenceEqualsItself)
{
  constexpr int Points = 400; // as in the reference
  test::MaskTrade mask = test::SphereMask();
  mask.TakeAsImage();
  const TradeRow row =
      mask.Trade().Measure(mask.SubVoxel(FieldInterpolation::TricubicBSpline, Points), GoOn);
  EXPECT_LT(row.PositionMost, 1e-12);
  EXPECT_NE(row.Truth.find("tricubic"), std::string::npos);
}

TEST(StructureTrade, EqualSeedsGiveEqualBits)
{
  const test::MaskTrade mask = test::SphereMask();
  const auto measure = [&mask](std::uint64_t seed)
  {
    return mask.Trade(test::ShortPath(seed))
        .Measure(mask.SubVoxel(FieldInterpolation::Trilinear, 26), GoOn);
  };
  const TradeRow first = measure(7);
  const TradeRow again = measure(7);
  EXPECT_EQ(first.PositionMean, again.PositionMean);
  EXPECT_EQ(first.DirectionMost, again.DirectionMost);
  EXPECT_EQ(first.JumpMean, again.JumpMean);
  EXPECT_NE(first.PositionMean, measure(8).PositionMean);
}

TEST(StructureTrade, ImpossibleRepresentationIsARowWithTheReason)
{
  test::MaskTrade horseshoe(
      [](double x, double y, double z)
      { return std::hypot(std::hypot(x, y) - 11.0, z) < 4.0 && (x < 8.0 || y < 0.0); });
  horseshoe.Scene.Fit.Model = FitSettings::ModelKind::Radial;
  StructureTrade trade = horseshoe.Trade();
  ContactSetting harmonics = SettingOf(horseshoe.Scene, TouchRepresentation::Harmonics);
  harmonics.Structure.Degree = 8;
  const TradeRow row = trade.Measure(harmonics, GoOn);
  EXPECT_EQ(row.State, TradeRow::Outcome::Refused);
  EXPECT_NE(row.Message.find("star-shaped"), std::string::npos) << row.Message;
  EXPECT_TRUE(std::isnan(row.PositionMean));
  EXPECT_EQ(trade.Measure(SettingOf(horseshoe.Scene, TouchRepresentation::Facets), GoOn).State,
            TradeRow::Outcome::Measured);
}

// A bent tube as a model: its contact follows the certified search.
TEST(StructureTrade, SurfaceModelsAreMeasuredAgainstThemselves)
{
  const test::TemporaryFolder folder;
  WriteModel(folder / "tube.json", {test::OpenRing(8), {}});
  SceneSettings scene;
  scene.Structures.resize(1);
  scene.Structures[0].Id = 1;
  scene.Structures[0].File = folder / "tube.json";
  const test::StillClock clock;
  StructureTrade trade(scene, scene.Structures[0], SceneRun(), test::ShortPath(), clock);
  const TradeRow row = trade.Measure(SettingOf(scene, TouchRepresentation::Harmonics), GoOn);
  ASSERT_EQ(row.State, TradeRow::Outcome::Measured) << row.Message;
  EXPECT_LT(row.PositionMost, 1e-5); // the tracker's tolerance
  EXPECT_EQ(row.Seizures, 0.0);
  EXPECT_NE(row.Represented.find("surface harmonics of degree 8"), std::string::npos);

  ContactSetting radial = SettingOf(scene, TouchRepresentation::Harmonics);
  radial.Structure.Mode = RadialContactMode::Radial;
  const TradeRow refused = trade.Measure(radial, GoOn);
  EXPECT_EQ(refused.State, TradeRow::Outcome::Refused);
  EXPECT_NE(refused.Message.find("nearest point"), std::string::npos) << refused.Message;
}

TEST(StructureTrade, HarmonicsOfAHorseshoeAreASurfaceModel)
{
  const test::MaskTrade horseshoe(
      [](double x, double y, double z)
      { return std::hypot(std::hypot(x, y) - 11.0, z) < 4.0 && (x < 8.0 || y < 0.0); });
  StructureTrade trade = horseshoe.Trade();
  ContactSetting harmonics = SettingOf(horseshoe.Scene, TouchRepresentation::Harmonics);
  harmonics.Structure.Degree = 8;
  const TradeRow row = trade.Measure(harmonics, GoOn);
  ASSERT_EQ(row.State, TradeRow::Outcome::Measured) << row.Message;
  // Against the mask's field: the shape that degree 8 leaves out, below half a voxel.
  EXPECT_LT(row.SurfaceMean, 0.4);
}

TEST(StructureTrade, EveryCandidateOfAMaskCanBeMeasured)
{
  const test::MaskTrade mask = test::SphereMask();
  StructureTrade trade = mask.Trade();
  const std::vector<ContactSetting> candidates = trade.Candidates(GoOn);
  EXPECT_GT(candidates.size(), 10U);
  for (const TradeRow& row : trade.MeasureAll(candidates, GoOn))
  {
    EXPECT_EQ(row.State, TradeRow::Outcome::Measured) << Describe(row.Setting) << row.Message;
    EXPECT_LT(row.PositionRare, 2.0) << Describe(row.Setting);
  }
}

TEST(StructureTrade, CandidatesDiffer)
{
  const test::MaskTrade mask = test::SphereMask();
  std::set<std::string> keys;
  for (const ContactSetting& candidate : mask.Trade().Candidates(GoOn))
  {
    EXPECT_TRUE(keys.insert(KeyOf(candidate)).second) << KeyOf(candidate);
  }
}

TEST(StructureTrade, CandidatesOfAModelAreItsModes)
{
  const test::TemporaryFolder folder;
  WriteModel(folder / "model.json", {test::BumpyModel(0.5), {}});
  SceneSettings scene;
  scene.Structures.resize(1);
  scene.Structures.front().File = folder / "model.json";
  ASSERT_EQ(CandidatesFor(scene, 0).size(), 2U);
  EXPECT_EQ(Describe(CandidatesFor(scene, 0).front()), "harmonics, nearest point")
      << "of its own degree";
  scene.Tool.Kind = TouchToolSettings::Shape::Ellipsoid;
  EXPECT_TRUE(CandidatesFor(scene, 0).empty());
  const test::StillClock clock;
  StructureTrade trade(scene, scene.Structures.front(), SceneRun(), test::ShortPath(), clock);
  EXPECT_THROW(trade.Measure(SettingOf(scene, TouchRepresentation::Harmonics), GoOn), InputError);
}

TEST(StructureTrade, DisplayAndDrillTakeNoPart)
{
  test::MaskTrade horseshoe(
      [](double x, double y, double z)
      { return std::hypot(std::hypot(x, y) - 11.0, z) < 4.0 && (x < 8.0 || y < 0.0); });
  SceneStructure& structure = horseshoe.Scene.Structures.front();
  structure.IsVisible = true;
  structure.Appearance = SceneAppearance::Model; // which it has none of
  structure.Drill.Wear = 1.0;
  structure.Stiffness = 0.0;
  const TradeRow row =
      horseshoe.Trade().Measure(horseshoe.SubVoxel(FieldInterpolation::TricubicBSpline, 26), GoOn);
  EXPECT_EQ(row.State, TradeRow::Outcome::Measured) << row.Message;
  EXPECT_GT(row.NoticeableMean, 0.0) << "a stiffness of 0 is measured with the default";
}

TEST(StructureTrade, ToleranceDoesNotReplaceTheDegree)
{
  test::MaskTrade mask = test::SphereMask();
  mask.Scene.Fit.Tolerance = 0.5;
  StructureTrade trade = mask.Trade();
  ContactSetting setting = SettingOf(mask.Scene, TouchRepresentation::Harmonics);
  for (const int degree : {4, 8})
  {
    setting.Structure.Degree = degree;
    EXPECT_NE(trade.Measure(setting, GoOn).Represented.find("degree " + std::to_string(degree)),
              std::string::npos);
  }
}

TEST(StructureTrade, CanBeCancelled)
{
  const test::MaskTrade mask = test::SphereMask();
  StructureTrade trade = mask.Trade();
  const ContactSetting setting = mask.SubVoxel(FieldInterpolation::Trilinear, 26);
  const auto stop = [](double /*fraction*/, const std::string& stage) { return stage != "touch"; };
  EXPECT_THROW(trade.Measure(setting, stop), Cancelled);
  EXPECT_EQ(trade.Measure(setting, GoOn).State, TradeRow::Outcome::Measured)
      << "and can be used afterwards";
}

TEST(TradePath, StrokesBeginFreeAndStayWithinTheDepth)
{
  const test::ModelTrade trade(0.5);
  const TradePath& path = trade.Path;
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
  // Targets of consecutive ticks are at most 0.2 mm apart.
  EXPECT_LT(deepest, path.MostDepth + 0.2);
  EXPECT_GT(deepest, 0.5 * path.MostDepth);
  EXPECT_GT(touching, path.Ticks.size() / 2);
}

TEST(TradeErrors, NanForceGivesNan)
{
  const test::ModelTrade trade(0.5);
  const TradePath& path = trade.Path;
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

TEST(TradeErrors, ForceTenPercentTooStrongHasThatError)
{
  const test::ModelTrade trade(0.5);
  constexpr double Stiffness = 0.5; // N/mm
  std::vector<FeltTick> felt;
  for (const TradePath::Tick& tick : trade.Path.Ticks)
  {
    felt.push_back(
        {tick.Truth.IsTouching, 1.1 * Stiffness * (tick.Truth.ProxyWorld - tick.ProbeWorld)});
  }
  TradeRow row;
  CompareWithTruth(trade.Path, felt, Stiffness, row);
  // A tenth in units of 7 % for forces of at least half a newton; less below.
  EXPECT_NEAR(row.NoticeableRare, 0.1 / 0.07, 1e-9);
  EXPECT_LT(row.NoticeableMean, 0.1 / 0.07);
  EXPECT_LT(row.DirectionMost, 1e-5);
  EXPECT_NEAR(row.JumpMost, 1.1 * row.IdealJumpMost, 1e-12);
}
} // namespace
} // namespace palpate::structure_trade_test
