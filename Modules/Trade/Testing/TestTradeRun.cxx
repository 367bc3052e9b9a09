#include "TradeRun.h"

#include "FilterRun.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "MarkupCheck.h"
#include "ModelFile.h"
#include "TemporaryFolder.h"
#include "TradeCases.h"
#include "TradePage.h"
#include "TradeText.h"
#include "WholeFile.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using test::GoOn;

// Two models, as files of a scene.
class TradeRunTest : public testing::Test
{
protected:
  TradeRunTest()
  {
    this->AddModel("bumpy.json", 0.5);
    this->AddModel("other.json", 0.2);
    this->Settings.Path.Seconds = 0.6;
    this->Settings.Runs = 1;
    this->Settings.Table = this->Folder / "tradeoff.csv";
    this->Settings.Knobs = {TradeKnob::Degree};
    this->Settings.Program = "palpate 1";
  }

  void AddFile(const std::string& name)
  {
    SceneStructure structure;
    structure.File = this->Folder / name;
    this->Settings.Scene.Structures.push_back(structure);
  }
  void AddModel(const std::string& name, double height)
  {
    this->WriteBumps(name, height);
    this->AddFile(name);
  }
  void WriteBumps(const std::string& name, double height) const
  {
    const TradeSource model = test::BumpyModel(height);
    WriteModel(this->Folder / name, {*std::get<TradeSource::Model>(model.Is), {}});
  }
  TradeResult Measure(const ProgressFunction& progress = GoOn) const
  {
    return RunTrade(this->Settings, this->Clock, progress);
  }
  std::string Table() const { return ReadWholeFile(this->Settings.Table, 1U << 24U); }

  test::TemporaryFolder Folder;
  test::StillClock Clock;
  TradeRunSettings Settings;
};

TEST_F(TradeRunTest, MeasuresEveryStructureOfAScene)
{
  const TradeSource mask = test::BallMask();
  WriteImage(this->Folder / "ball.nii.gz",
             std::get<TradeSource::Mask>(mask.Is).Voxels->Layers.front());
  this->AddFile("ball.nii.gz");
  const TradeResult result = this->Measure();
  ASSERT_EQ(result.Structures.size(), 3U);
  EXPECT_EQ(result.Structures[0].Name, "bumpy");
  EXPECT_EQ(result.Structures[2].Name, "label 1");
  EXPECT_EQ(result.Kept, 0U);
  for (const TradeStructureResult& structure : result.Structures)
  {
    EXPECT_GT(structure.Rows.size(), 2U);
    EXPECT_TRUE(structure.Advice.Row);
  }
}

TEST_F(TradeRunTest, ACancelledRunGoesOnAndMakesTheSameTable)
{
  this->Measure();
  const std::string whole = this->Table();
  std::filesystem::remove(this->Settings.Table);
  const auto stopLater = [](double fraction, const std::string& /*stage*/)
  { return fraction < 0.6; };
  EXPECT_THROW(this->Measure(stopLater), Cancelled);
  const std::size_t rows = TradeTable::Read(this->Settings.Table).Rows().size();
  EXPECT_GT(rows, 0U);
  const TradeResult rest = this->Measure();
  EXPECT_EQ(rest.Kept, rows);
  EXPECT_EQ(this->Table(), whole);
}

TEST_F(TradeRunTest, WhatIsDoneIsNotMeasuredAgain)
{
  const TradeResult first = this->Measure();
  const TradeResult again = this->Measure();
  EXPECT_EQ(again.Kept, first.Structures[0].Rows.size() + first.Structures[1].Rows.size());
  EXPECT_EQ(TradeJson(first), TradeJson(again));
}

TEST_F(TradeRunTest, AnotherSeedToolOrProgramIsMeasuredAgainAndReplacesTheRows)
{
  this->Measure();
  const std::size_t rows = TradeTable::Read(this->Settings.Table).Rows().size();
  this->Settings.Path.Seed = 2;
  EXPECT_EQ(this->Measure().Kept, 0U);
  this->Settings.Scene.Tool.Radius = 1.0;
  EXPECT_EQ(this->Measure().Kept, 0U);
  this->Settings.Program = "palpate 2";
  EXPECT_EQ(this->Measure().Kept, 0U);
  EXPECT_EQ(TradeTable::Read(this->Settings.Table).Rows().size(), rows);
}

TEST_F(TradeRunTest, AnotherContentOfAFileIsMeasuredAgain)
{
  const TradeResult first = this->Measure();
  this->WriteBumps("bumpy.json", 0.4);
  EXPECT_EQ(this->Measure().Kept, first.Structures[1].Rows.size());
}

TEST_F(TradeRunTest, OneStructureLeavesTheOthersRows)
{
  const TradeResult all = this->Measure();
  this->Settings.Structures = {"bumpy"};
  const TradeResult one = this->Measure();
  ASSERT_EQ(one.Structures.size(), 1U);
  EXPECT_EQ(TradeTable::Read(this->Settings.Table).Rows().size(),
            all.Structures[0].Rows.size() + all.Structures[1].Rows.size());
  this->Settings.Structures = {"liver"};
  EXPECT_THROW(this->Measure(), InputError);
}

TEST_F(TradeRunTest, WhatIsOnlySeenIsNotMeasured)
{
  for (SceneStructure& structure : this->Settings.Scene.Structures)
  {
    structure.IsTouchable = false;
  }
  EXPECT_THROW(this->Measure(), InputError);
  this->Settings.Scene.Structures.front().IsTouchable = true;
  EXPECT_EQ(this->Measure().Structures.size(), 1U);
}

TEST_F(TradeRunTest, ThePageNeedsNothingElseAndRunsNothing)
{
  this->Settings.Scene.Structures.front().Name = "<b>bold</b> & co";
  this->Settings.Knobs.clear();
  const std::string page = TradePage(this->Measure());
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_EQ(page.find("<b>bold"), std::string::npos);
  EXPECT_EQ(page.find("nan"), std::string::npos);
  EXPECT_EQ(test::MarkupError(page), "");
  EXPECT_NE(page.find("<svg class=\"chart\""), std::string::npos);
}

TEST(TradeText, AReasonIsSaidOnceForAllItHoldsFor)
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
  const std::vector<std::string> sentences = RefusalsOf(structure);
  ASSERT_EQ(sentences.size(), 2U);
  EXPECT_EQ(sentences[0], "harmonics of degree 4, nearest point and 1 more: is not star-shaped");
  EXPECT_EQ(sentences[1], "harmonics of degree 12, nearest point: has too few samples");
}

TEST_F(TradeRunTest, TheJsonHasEveryNumberOfEveryRow)
{
  const TradeResult result = this->Measure();
  const nlohmann::json json = nlohmann::json::parse(TradeJson(result));
  ASSERT_EQ(json["structures"].size(), 2U);
  const nlohmann::json& row = json["structures"][0]["rows"][0];
  for (const TradeColumn& column : TradeColumns())
  {
    EXPECT_TRUE(row.contains(column.Name)) << column.Name;
  }
  EXPECT_TRUE(row["draw_mean_mm"].is_null()) << "a row that is felt is not drawn";
  EXPECT_FALSE(json["structures"][0]["truth"].get<std::string>().empty());
}
} // namespace
} // namespace palpate
