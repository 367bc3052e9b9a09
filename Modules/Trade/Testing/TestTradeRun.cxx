#include "TradeRun.h"

#include "InputError.h"
#include "MarkupCheck.h"
#include "ModelFile.h"
#include "Progress.h"
#include "TradeCases.h"
#include "TradePage.h"
#include "TradeText.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::trade_run_test
{
namespace
{
using test::GoOn;

// Two models and a mask, as files of a scene.
class TradeRunTest : public testing::Test
{
protected:
  TradeRunTest()
  {
    for (const char* name : {"bumpy", "other"})
    {
      const std::filesystem::path file = this->Folder / (std::string(name) + ".json");
      WriteModel(file, {test::BumpyModel(0.5), {}});
      this->Settings.Scene.Structures.emplace_back();
      this->Settings.Scene.Structures.back().File = file;
    }
    this->Settings.Scene.Structures.push_back(this->Mask.Scene.Structures.front());
    this->Settings.Measurement.Path.Seconds = 0.6;
    this->Settings.Measurement.Runs = 1;
    this->Settings.Program = "palpate 1";
  }
  TradeResult Measure(const ProgressFunction& progress = GoOn) const
  {
    return RunTrade(this->Settings, this->Clock, progress);
  }

  test::TemporaryFolder Folder;
  test::MaskTrade Mask = test::SphereMask();
  test::StillClock Clock;
  TradeRunSettings Settings;
};

TEST_F(TradeRunTest, MeasuresEveryStructureOfAScene)
{
  const TradeResult result = this->Measure();
  ASSERT_EQ(result.Structures.size(), 3U);
  EXPECT_EQ(result.Structures[0].Name, "bumpy");
  EXPECT_EQ(result.Structures[2].Name, "label 1");
  for (const TradeStructureResult& structure : result.Structures)
  {
    EXPECT_GE(structure.Rows.size(), 2U);
    EXPECT_TRUE(structure.Advice.Row);
  }
}

TEST_F(TradeRunTest, AdvisedSceneDiffersByTheAdvisedSettingsAlone)
{
  this->Settings.Scene.Structures[0].IsVisible = false;
  this->Settings.Scene.Structures[1].IsTouchable = false;
  this->Settings.Scene.Structures[2].Representation = TouchRepresentation::SubVoxel;
  const TradeResult result = this->Measure();
  const std::vector<SceneStructure>& advised = result.Advised.Structures;
  ASSERT_EQ(advised.size(), 3U);
  ASSERT_EQ(result.Structures.size(), 2U);
  EXPECT_FALSE(advised[0].IsVisible);
  EXPECT_FALSE(advised[1].IsTouchable);
  EXPECT_TRUE(advised[2].IsVisible);
  EXPECT_EQ(advised[1].Representation, TouchRepresentation::Automatic) << "not measured";
  for (const std::size_t measured : {0U, 1U})
  {
    const TradeStructureResult& one = result.Structures[measured];
    ASSERT_TRUE(one.Advice.Row);
    ContactSetting setting = one.Rows[*one.Advice.Row].Setting;
    const ContactSetting applied{advised[2 * measured], setting.ToolPoints};
    EXPECT_EQ(KeyOf(applied), KeyOf(setting));
    EXPECT_EQ(applied.Structure.Stiffness, setting.Structure.Stiffness);
  }
}

TEST_F(TradeRunTest, MeasuresOnlyTheNamedStructures)
{
  this->Settings.Structures = {"other"};
  const TradeResult one = this->Measure();
  ASSERT_EQ(one.Structures.size(), 1U);
  EXPECT_EQ(one.Structures[0].Name, "other");
  this->Settings.Structures = {"liver"};
  EXPECT_THROW(this->Measure(), InputError);
}

TEST_F(TradeRunTest, MeasuresOnlyTouchableStructures)
{
  for (SceneStructure& structure : this->Settings.Scene.Structures)
  {
    structure.IsTouchable = false;
  }
  EXPECT_THROW(this->Measure(), InputError);
  this->Settings.Scene.Structures.front().IsTouchable = true;
  EXPECT_EQ(this->Measure().Structures.size(), 1U);
}

TEST_F(TradeRunTest, CanBeCancelled)
{
  const auto stop = [](double fraction, const std::string& /*stage*/) { return fraction < 0.5; };
  EXPECT_THROW(this->Measure(stop), Cancelled);
}

TEST_F(TradeRunTest, PageIsOneFileWithoutScripts)
{
  this->Settings.Scene.Structures.front().Name = "<b>bold</b> & co";
  const std::string page = TradePage(this->Measure());
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_EQ(page.find("<b>bold"), std::string::npos);
  EXPECT_EQ(page.find("nan"), std::string::npos);
  EXPECT_EQ(test::MarkupError(page), "");
  EXPECT_NE(page.find("<svg class=\"chart\""), std::string::npos);
}

TEST(TradeText, StatesEachReasonOnce)
{
  TradeStructureResult structure;
  for (const int degree : {4, 8, 12})
  {
    TradeRow row;
    row.Setting = test::Harmonics(degree);
    row.State = TradeRow::Outcome::Refused;
    row.Message = degree < 12 ? "is not star-shaped" : "has too few samples";
    structure.Rows.push_back(row);
  }
  const std::vector<std::string> messages = RefusalsOf(structure);
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0], "harmonics of degree 4, nearest point and 1 more: is not star-shaped");
  EXPECT_EQ(messages[1], "harmonics of degree 12, nearest point: has too few samples");
}

TEST_F(TradeRunTest, TableAndJsonHaveTheSameNumbers)
{
  this->Settings.Structures = {"bumpy"};
  const TradeResult result = this->Measure();
  const nlohmann::json json = nlohmann::json::parse(TradeJson(result));
  const nlohmann::json& row = json["structures"][0]["rows"][0];
  EXPECT_FALSE(json["structures"][0]["reference"].get<std::string>().empty());
  const std::string table = TradeCsv(result);
  EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')),
            1 + result.Structures[0].Rows.size());
  for (const char* column : {"tick_mean_ns", "position_p99_mm", "seizures", "bytes"})
  {
    EXPECT_TRUE(row.at(column).is_number()) << column;
    EXPECT_NE(table.find(column), std::string::npos) << column;
  }
  EXPECT_NE(table.find("," + row["bytes"].dump().substr(0, 4)), std::string::npos);
}
} // namespace
} // namespace palpate::trade_run_test
