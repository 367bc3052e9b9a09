#include "MarkupCheck.h"
#include "ModelFile.h"
#include "ModelSoftening.h"
#include "Progress.h"
#include "SceneTissue.h"
#include "TradeAdvice.h"
#include "TradeCases.h"
#include "TradeErrors.h"
#include "TradePage.h"
#include "TradeText.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

namespace palpate::elastic_trade_test
{
namespace
{
using test::GoOn;

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// A sphere of 20 mm and 20 kPa of few elements, with a stiff ball of 5 mm below its surface.
class SoftSphere
{
public:
  SoftSphere()
  {
    WriteModel(this->Folder / "sphere.json", {test::BumpyModel(0.0), {}});
    this->WriteMask([](double x, double y, double z) { return std::hypot(x - 13.0, y, z) < 5.0; });
    SceneStructure sphere;
    sphere.Id = 1;
    sphere.File = this->Folder / "sphere.json";
    sphere.Representation = TouchRepresentation::Elastic;
    sphere.SetNumber(TissueKey::Elements, 6.0);
    SceneStructure core;
    core.Id = 2;
    core.File = this->Folder / "core.nii.gz";
    core.IsVisible = core.IsTouchable = false;
    core.SetNumber(TissueKey::Inclusion, 200.0);
    this->Scene.Structures = {sphere, core};
    this->Scene.Tool.Radius = 4.0;
  }
  // Of the second structure; relative to the centre of the sphere, whose left half it covers.
  template <typename Inside>
  void WriteMask(const Inside& inside) const
  {
    test::LabelGrid grid;
    const Vector3 center = test::BumpyModel(0.0).CenterWorld();
    grid.Origin = {{center.x() - 2.0, center.y() - 15.5, center.z() - 15.5}};
    WriteImage(
        this->Folder / "core.nii.gz",
        test::MakeLabelImage(grid, [&](double x, double y, double z)
                             { return inside(x - center.x(), y - center.y(), z - center.z()); }));
  }
  StructureTrade Trade() const
  {
    return {this->Scene, this->Scene.Structures.front(), SceneRun(), test::ShortPath(), this->Time};
  }
  ContactSetting Standard() const { return SettingOf(this->Scene, TouchRepresentation::Elastic); }

  test::TemporaryFolder Folder;
  test::StillClock Time;
  SceneSettings Scene;
};

std::set<std::string> KeysOf(const std::vector<ContactSetting>& settings)
{
  std::set<std::string> keys;
  for (const ContactSetting& setting : settings)
  {
    EXPECT_TRUE(keys.insert(KeyOf(setting)).second) << KeyOf(setting);
  }
  return keys;
}

// Measured once, since softening takes seconds.
class ElasticTrade : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    Sphere = new SoftSphere();
    Trade = new StructureTrade(Sphere->Trade());
    Rows = new std::vector<TradeRow>(Trade->MeasureAll(Trade->Candidates(GoOn), GoOn));
  }
  static void TearDownTestSuite()
  {
    delete Rows;
    delete Trade;
    delete Sphere;
  }
  static const TradeRow& RowOf(const std::string& key)
  {
    for (const TradeRow& row : *Rows)
    {
      if (KeyOf(row.Setting) == key)
      {
        return row;
      }
    }
    ADD_FAILURE() << "no row " << key;
    return Rows->front();
  }
  static TradeResult Result()
  {
    TradeResult result;
    result.Structures.push_back({"sphere", *Rows, AdviseOn(*Rows, 1000.0)});
    return result;
  }

  static inline SoftSphere* Sphere = nullptr;
  static inline StructureTrade* Trade = nullptr;
  static inline std::vector<TradeRow>* Rows = nullptr;
};

TEST(ElasticCandidates, VaryOneNumberAtATime)
{
  SoftSphere sphere;
  sphere.Scene.Structures.front().SetNumber(TissueKey::Elements, 0.0);
  EXPECT_EQ(
      KeysOf(CandidatesFor(sphere.Scene, 0)),
      (std::set<std::string>{
          "elastic/elements-16/compliance-auto/maps-20",
          "elastic/elements-12/compliance-auto/maps-20",
          "elastic/elements-8/compliance-auto/maps-20", "elastic/elements-16/compliance-16/maps-20",
          "elastic/elements-16/compliance-8/maps-20", "elastic/elements-16/compliance-auto/maps-16",
          "elastic/elements-16/compliance-auto/maps-12",
          "elastic/elements-16/compliance-auto/maps-8", "harmonics/nearest"}));
  sphere.Scene.Tool.Kind = TouchToolSettings::Shape::Ellipsoid;
  EXPECT_TRUE(CandidatesFor(sphere.Scene, 0).empty());
}

TEST(ElasticCandidates, RigidStructuresHaveNone)
{
  SoftSphere sphere;
  sphere.Scene.Structures.front().Representation = TouchRepresentation::Automatic;
  EXPECT_EQ(KeysOf(sphere.Trade().Candidates(GoOn)),
            (std::set<std::string>{"harmonics/nearest", "harmonics/radial"}));
}

TEST_F(ElasticTrade, MeasuresEverySettingByItsOwnForce)
{
  EXPECT_GE(Rows->size(), 8U);
  for (const TradeRow& row : *Rows)
  {
    ASSERT_EQ(row.State, TradeRow::Outcome::Measured) << Describe(row) << row.Message;
    EXPECT_GT(row.JumpMean, 0.0) << Describe(row);
    EXPECT_EQ(row.Seizures, 0.0) << Describe(row);
    EXPECT_TRUE(std::isnan(row.PositionMean)) << Describe(row);
    EXPECT_TRUE(Has(row.Truth, "8 elements across, compliance of degree 8, maps of degree 24"))
        << row.Truth;
  }
  const TradeRow& standard = Rows->front();
  EXPECT_TRUE(Has(standard.Represented, "inclusions of 200 kPa")) << standard.Represented;
  EXPECT_GT(standard.ForceMean, 0.0);
  EXPECT_LT(standard.NoticeableMean, 0.5);
}

TEST_F(ElasticTrade, ErrorsShrinkWithTheDegreeOfTheMaps)
{
  const auto errorOf = [](int degree)
  { return RowOf("elastic/elements-6/compliance-auto/maps-" + std::to_string(degree)).ForceMean; };
  EXPECT_GT(errorOf(8), errorOf(12));
  EXPECT_GT(errorOf(12), errorOf(16));
  // From there on the elements' error is larger than that of the maps.
  EXPECT_LT(errorOf(20), errorOf(12));
}

TEST_F(ElasticTrade, MapsOfLowerDegreeAreSmaller)
{
  EXPECT_LT(RowOf("elastic/elements-6/compliance-auto/maps-8").Bytes, Rows->front().Bytes);
}

TEST_F(ElasticTrade, RigidRowHasTheLargestError)
{
  const TradeRow& rigid = Rows->back();
  EXPECT_EQ(Describe(rigid).rfind("rigid, harmonics", 0), 0U) << Describe(rigid);
  for (const TradeRow& row : *Rows)
  {
    EXPECT_TRUE(&row == &rigid || rigid.NoticeableMean > 5.0 * row.NoticeableMean) << Describe(row);
  }
  EXPECT_GT(rigid.NoticeableMean, 3.0);
}

TEST_F(ElasticTrade, TissueTwiceAsStiffIsSeen)
{
  ContactSetting wrong = Sphere->Standard();
  wrong.Structure.SetNumber(TissueKey::Modulus, 40.0);
  const TradeRow row = Trade->Measure(wrong, GoOn);
  ASSERT_EQ(row.State, TradeRow::Outcome::Measured) << row.Message;
  EXPECT_GT(row.NoticeableRare, 1.0);
  EXPECT_GT(row.ForceMean, 5.0 * Rows->front().ForceMean);
}

TEST_F(ElasticTrade, RecommendsByTheRule)
{
  std::vector<TradeRow> rows = *Rows;
  double time = 5e3;
  double cost = 1e3;
  for (TradeRow& row : rows)
  {
    row.TickMean = row.TickRare = time -= 100.0; // the rigid row is the fastest and cheapest
    row.CostSeconds = cost *= 0.7;
    row.Rate = 1e9 / row.TickRare;
  }
  const TradeAdvice advice = AdviseOn(rows, 1000.0);
  ASSERT_TRUE(advice.Row);
  EXPECT_TRUE(advice.IsMet) << advice.Message;
  EXPECT_NE(*advice.Row + 1, rows.size()) << advice.Message;
  for (std::size_t r = *advice.Row + 1; r < rows.size(); ++r)
  {
    EXPECT_TRUE(rows[r].NoticeableRare >= 1.0 ||
                rows[r].DirectionRare >= TradeThresholds::NoticeableDegrees)
        << Describe(rows[r]) << " is cheaper";
  }
  EXPECT_FALSE(Has(advice.Message, " mm")) << advice.Message;
}

TEST_F(ElasticTrade, JsonAndPageHaveForcesInsteadOfPositions)
{
  const nlohmann::json json = nlohmann::json::parse(TradeJson(Result()));
  const nlohmann::json& row = json["structures"][0]["rows"][0];
  EXPECT_TRUE(row["position_mean_mm"].is_null());
  EXPECT_TRUE(row["force_p99_n"].is_number());
  EXPECT_EQ(json["structures"][0]["rows"].back()["representation"], "harmonics");
  const std::string page = TradePage(Result());
  EXPECT_FALSE(Has(page, "Position error of the tool"));
  EXPECT_TRUE(Has(page, "Force, mN"));
  EXPECT_TRUE(Has(page, "rigid, harmonics"));
  EXPECT_FALSE(Has(page, "nan"));
  EXPECT_EQ(test::MarkupError(page), "");
}

TEST(ElasticTradeRun, CanBeCancelledWhileSoftening)
{
  const SoftSphere sphere;
  StructureTrade trade = sphere.Trade();
  const auto stop = [](double, const std::string& stage) { return !Has(stage, "elasticity"); };
  EXPECT_THROW(trade.Measure(sphere.Standard(), stop), Cancelled);
}

TEST(ElasticTradeRun, KeepsWhatHoldsTheStructure)
{
  SoftSphere sphere;
  sphere.WriteMask([](double x, double y, double z) { return std::hypot(x, y, z) >= 20.0; });
  SceneStructure& core = sphere.Scene.Structures.back();
  core.SetNumber(TissueKey::Inclusion, 0.0);
  const auto stiffness = [&sphere]
  {
    const auto contact = sphere.Trade().ContactFor(sphere.Standard(), GoOn);
    return contact->Model->OwnStiffness(ToolShape::Sphere(4.0));
  };
  const double alone = stiffness();
  core.SetNumber(TissueKey::Neighbour, 50.0);
  EXPECT_GT(stiffness(), 1.02 * alone);
}

TEST(ElasticTradeFile, OnlyItsMapsCanBeVaried)
{
  SoftSphere sphere;
  SofteningSettings settings;
  settings.Numbers.ElementsAcross = 4;
  settings.Numbers.Degree = 4;
  settings.Numbers.Maps.Degree = 10;
  ModelDocument model{test::BumpyModel(0.5), {}};
  model.Elasticity = SoftenModel(model.Surface, "sphere", settings, GoOn).Elasticity;
  WriteModel(sphere.Folder / "soft.json", model);
  SceneStructure& structure = sphere.Scene.Structures.front();
  structure = SceneStructure();
  structure.File = sphere.Folder / "soft.json";
  StructureTrade trade = sphere.Trade();
  const std::vector<ContactSetting> candidates = trade.Candidates(GoOn);
  EXPECT_EQ(KeysOf(candidates),
            (std::set<std::string>{"elastic/maps-10", "elastic/maps-8", "elastic/maps-6",
                                   "elastic/maps-4", "harmonics/nearest"}));
  const std::vector<TradeRow> rows = trade.MeasureAll(candidates, GoOn);
  EXPECT_TRUE(Has(rows.front().Truth, "its tissue is not known")) << rows.front().Truth;
  EXPECT_LT(rows.front().NoticeableRare, 1e-9);
  EXPECT_GT(rows.back().NoticeableMean, 3.0);
  structure.Representation = TouchRepresentation::Harmonics;
  EXPECT_EQ(KeysOf(sphere.Trade().Candidates(GoOn)).count("harmonics/radial"), 1U)
      << "a scene may choose to touch it as a rigid one";
}

TEST(TradeErrors, ForcesOfAYieldingStructureAreComparedAsTheyAre)
{
  const test::ModelTrade trade(0.5);
  TradePath path = trade.Path;
  std::vector<FeltTick> felt;
  for (TradePath::Tick& tick : path.Ticks)
  {
    tick.Truth.ForceWorld =
        tick.Truth.IsTouching ? Vector3(tick.Truth.NormalWorld) : Vector3(Vector3::Zero());
    felt.push_back({tick.Truth.IsTouching, 1.1 * *tick.Truth.ForceWorld, tick.Truth.ProxyWorld});
  }
  TradeRow row;
  CompareWithTruth(path, felt, 0.5, row);
  EXPECT_NEAR(row.ForceMean, 0.1, 1e-12);
  EXPECT_NEAR(row.NoticeableRare, 0.1 / 0.07, 1e-9);
  EXPECT_TRUE(std::isnan(row.PositionMean));
  EXPECT_EQ(row.Seizures, 0.0);
  const auto touching =
      std::find_if(felt.begin(), felt.end(), [](const FeltTick& tick) { return tick.IsTouching; });
  ASSERT_NE(touching, felt.end());
  touching->ProxyWorld += Vector3(3.0, 0.0, 0.0);
  CompareWithTruth(path, felt, 0.5, row);
  EXPECT_EQ(row.Seizures, 1.0);
}
} // namespace
} // namespace palpate::elastic_trade_test
