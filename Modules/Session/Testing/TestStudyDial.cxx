#include "Study.h"
#include "StudyDialReport.h"

#include "SteadyClock.h"
#include "StudyPhantoms.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
constexpr double Rate = 1000.0; // Hz

// A rung of which everything was measured; us and mm. Forces are far off.
TradeRow Row(double tick, double error)
{
  TradeRow row;
  row.TickMean = row.TickRare = 1e3 * tick;
  row.SurfaceMean = error;
  row.NoticeableMean = 10.0;
  row.DirectionMean = 1.0;
  return row;
}

// Of voxels that tell a surface to 0.29 mm.
StudyTrade TradeOf(std::vector<TradeRow> rows)
{
  StudyTrade trade;
  trade.Rungs = std::move(rows);
  trade.VoxelMillimeters = 1.0;
  return trade;
}

TEST(StudyDial, EveryRungHasItsPlaceAndTheOthersHaveNone)
{
  for (std::size_t n = 0; n < AllStudyRungs.size(); ++n)
  {
    EXPECT_EQ(RungOf(AllStudyRungs[n]), static_cast<int>(n));
  }
  EXPECT_EQ(RungOf(StudyDial::ByHand), -1);
  EXPECT_EQ(RungOf(StudyDial::Automatic), -1);
  TouchToolSettings tool;
  tool.Points = 26;
  EXPECT_EQ(Describe(SettingOf(1, tool)), "harmonics of degree 8, nearest point");
  EXPECT_EQ(SettingOf(5, tool).Interpolation, FieldInterpolation::TricubicBSpline);
  EXPECT_EQ(SettingOf(5, tool).ToolPoints, 26);
}

TEST(StudyDial, AutomaticTakesTheFastestThatIsAsTrueAsVoxelsTell)
{
  EXPECT_EQ(ChosenRung(TradeOf({Row(0.1, 0.8), Row(0.2, 0.28), Row(0.4, 0.1)}), Rate), 1);
  EXPECT_EQ(ChosenRung(TradeOf({Row(0.1, 0.8), Row(0.9, 0.28), Row(0.4, 0.1)}), Rate), 2);
}

TEST(StudyDial, AutomaticTakesWhatNoHandCanTellFromTheTruth)
{
  TradeRow light = Row(0.1, 0.8);
  light.NoticeableMean = 0.9;
  EXPECT_EQ(ChosenRung(TradeOf({light, Row(0.2, 0.1)}), Rate), 0);
  light.DirectionMean = 20.0;
  EXPECT_EQ(ChosenRung(TradeOf({light, Row(0.2, 0.1)}), Rate), 1);
}

TEST(StudyDial, AutomaticTakesTheTruestThatFitsWhereNoneIsTrueEnough)
{
  EXPECT_EQ(ChosenRung(TradeOf({Row(0.1, 0.9), Row(0.2, 0.5), Row(400.0, 0.1)}), Rate), 1);
  // With more time for a tick the truest fits too.
  EXPECT_EQ(ChosenRung(TradeOf({Row(0.1, 0.9), Row(0.2, 0.5), Row(400.0, 0.1)}), 500.0), 2);
  EXPECT_EQ(ChosenRung(TradeOf({Row(900.0, 0.1), Row(500.0, 0.9)}), Rate), 1);
}

TEST(StudyDial, WhatWasRefusedOrNotMeasuredIsNotTaken)
{
  TradeRow refused;
  refused.State = TradeRow::Outcome::Refused;
  EXPECT_EQ(ChosenRung(TradeOf({refused, TradeRow(), Row(1.0, 0.2)}), Rate), 2);
  EXPECT_EQ(ChosenRung(TradeOf({refused, TradeRow()}), Rate), -1);
  EXPECT_EQ(ChosenRung(StudyTrade(), Rate), -1);
  const StudyTrade trade =
      TradeOf({refused, refused, refused, refused, Row(1.0, 0.2), Row(9.0, 0.1)});
  EXPECT_EQ(RowOf(trade, 0), &trade.Rungs[4]) << "a field takes the place of harmonics";
  EXPECT_EQ(RowOf(trade, 5), &trade.Rungs[5]);
  EXPECT_EQ(RowOf(StudyTrade(), 3), nullptr);
}

TEST(StudyDial, StructuresAreFeltAsTheDialSays)
{
  StudyState state;
  StudyStructure structure;
  structure.Representation = TouchRepresentation::Facets;
  structure.Degree = 7;
  EXPECT_EQ(Describe(FeelOf(state, structure, nullptr)), "facets");
  state.Dial = StudyDial::Harmonics16;
  EXPECT_EQ(FeelOf(state, structure, nullptr).Degree, 16);
  EXPECT_EQ(FeelOf(state, structure, nullptr).Representation, TouchRepresentation::Automatic);
  // What a small structure supports is known once it was measured.
  StudyTrade trade = TradeOf(
      {Row(0.1, 0.9), Row(0.1, 0.9), Row(0.1, 0.9), Row(0.1, 0.9), Row(1.0, 0.2), Row(9.0, 0.1)});
  for (int rung = 0; rung < 6; ++rung)
  {
    trade.Rungs[static_cast<std::size_t>(rung)].Setting = SettingOf(rung, {});
  }
  trade.Rungs[3].Setting.Degree = 10;
  EXPECT_EQ(FeelOf(state, structure, &trade).Degree, 10);
  state.Dial = StudyDial::SubVoxelCubic;
  EXPECT_EQ(Describe(FeelOf(state, structure, &trade)), "sub-voxel, cubic");
  EXPECT_EQ(FeelOf(state, structure, &trade).Degree, 7) << "of what is seen of its harmonics";
  state.Dial = StudyDial::Automatic;
  EXPECT_EQ(Describe(FeelOf(state, structure, nullptr)), "harmonics of degree 12");
  EXPECT_EQ(Describe(FeelOf(state, structure, &trade)), "sub-voxel, linear");
}

TEST(StudyDial, ItsNumbersAreOneSentence)
{
  StudyDialLine one;
  one.Title = "liver";
  one.Settings = "harmonics of degree 8";
  StudyDialLine other = one;
  EXPECT_EQ(TextOf(one), "liver: harmonics of degree 8");
  EXPECT_EQ(DialNumbersText({one}, 0.0), "Tick: not known yet. Error: not known yet.");
  one.TickMicroseconds = 0.31;
  one.ErrorMillimeters = 0.4;
  other.TickMicroseconds = 1.2;
  other.ErrorMillimeters = 0.1;
  EXPECT_EQ(TextOf(one), "liver: harmonics of degree 8, 0.31 \u00B5s, 0.4 mm");
  EXPECT_EQ(DialNumbersText({one, other}, 3.0),
            "Tick: 1.2 \u00B5s expected, 3 \u00B5s measured. Error: 0.4 mm expected.");
  EXPECT_EQ(DialNumbersText({}, 3.0), "Tick: 3 \u00B5s measured. Error: not known yet.");
  one.MeasuringFraction = 0.25;
  EXPECT_EQ(TextOf(one), "liver: harmonics of degree 8, 0.31 \u00B5s, 0.4 mm, measuring (25 %)");
  EXPECT_EQ(DialNumbersText({one, other}, 0.0),
            "Tick: 1.2 \u00B5s expected. Error: 0.4 mm expected. Measuring: 1 to go.");
}

class StudyDialTest : public testing::Test
{
protected:
  void Make()
  {
    this->Pipeline.Update(this->State);
    test::Settle(this->Jobs);
  }
  std::string Represented(int label = 1) const
  {
    const auto contact = this->Pipeline.Newest<TouchContact>(StudyStep::Touch, label);
    return contact != nullptr ? contact->Represented : "nothing";
  }

  test::StudyPhantom Phantom;
  StudyState State = Phantom.State();
  StudyJobs Jobs;
  StudyPipeline Pipeline{Jobs};
};

TEST_F(StudyDialTest, ByHandNothingIsMeasured)
{
  this->Make();
  EXPECT_EQ(this->Pipeline.StateOf(StudyStep::Trade, 1).Is, StudyStepState::Kind::NotWanted);
  EXPECT_EQ(this->Represented(), "harmonics of degree 4, nearest point");
  EXPECT_FALSE(DialLinesOf(this->State, this->Pipeline)[0].TickMicroseconds.has_value());
}

TEST_F(StudyDialTest, ARungIsFeltAndMeasured)
{
  this->State.Dial = StudyDial::Harmonics8;
  this->Make();
  EXPECT_EQ(this->Represented(), "harmonics of degree 8, nearest point");
  const auto trade = this->Pipeline.Newest<StudyTrade>(StudyStep::Trade, 1);
  ASSERT_NE(trade, nullptr);
  ASSERT_EQ(trade->Rungs.size(), AllStudyRungs.size());
  const StudyDialLine line = DialLinesOf(this->State, this->Pipeline)[0];
  EXPECT_EQ(line.Settings, "harmonics of degree 8");
  EXPECT_GT(*line.TickMicroseconds, 0.0);
  // A ball of 9 mm in voxels of 1 mm, smoothed: the mask is known to about a voxel.
  EXPECT_LT(*line.ErrorMillimeters, 1.0);
  EXPECT_EQ(std::count(line.Rungs.begin(), line.Rungs.end(), '\n'), 5);
  const std::uint64_t started = this->Pipeline.StartedCount();
  this->State.Dial = StudyDial::SubVoxelCubic;
  this->Make();
  EXPECT_NE(this->Represented().find("tricubic"), std::string::npos) << this->Represented();
  EXPECT_EQ(this->Pipeline.StartedCount(), started + 3) << "a field, its contact, its cost";
}

TEST_F(StudyDialTest, AutomaticIsFeltAtOnceAndThenAsItWasMeasured)
{
  this->State.Dial = StudyDial::Automatic;
  this->Make();
  const auto trade = this->Pipeline.Newest<StudyTrade>(StudyStep::Trade, 1);
  ASSERT_NE(trade, nullptr);
  const StudyFeel feel = FeelOf(this->State, this->State.Structures[0], trade.get());
  EXPECT_EQ(feel.Rung, ChosenRung(*trade, this->State.Rate));
  const std::string expected = feel.Representation == TouchRepresentation::SubVoxel
                                   ? "sub-voxel"
                                   : "degree " + std::to_string(feel.Degree);
  EXPECT_NE(this->Represented().find(expected), std::string::npos) << this->Represented();
}

TEST_F(StudyDialTest, WhatIsNotStarShapedIsFeltByItsField)
{
  this->State.Structures = {test::StudyPhantom::Structure(2, TouchRepresentation::Automatic)};
  this->State.Dial = StudyDial::Harmonics4;
  this->Make();
  EXPECT_NE(this->Represented(2).find("sub-voxel"), std::string::npos);
  const StudyDialLine line = DialLinesOf(this->State, this->Pipeline)[0];
  EXPECT_EQ(line.Settings, "sub-voxel, linear");
  EXPECT_GT(*line.TickMicroseconds, 0.0);
}

TEST_F(StudyDialTest, AToolThatCannotBeMeasuredIsSaid)
{
  this->State.Dial = StudyDial::Harmonics4;
  this->State.Tool.Radius = -1.0;
  this->Make();
  EXPECT_FALSE(DialLinesOf(this->State, this->Pipeline)[0].Problem.empty());
}

TEST(StudyOfADial, ADraggedDialIsOneStepAndAChoiceByHandTurnsIt)
{
  const test::StudyPhantom phantom;
  SteadyClock clock;
  Study study(clock);
  study.Change("open", phantom.State());
  for (const StudyDial dial : {StudyDial::Harmonics8, StudyDial::Harmonics4})
  {
    StudyState next = study.State();
    next.Dial = dial;
    study.Change(std::string("Turn the dial to ") + NameOf(dial), next, "dial");
  }
  study.EndGesture();
  EXPECT_EQ(study.History().UndoText(), "Turn the dial to harmonics of degree 4");
  study.Undo();
  EXPECT_EQ(study.State().Dial, StudyDial::ByHand);
  study.Redo();
  EXPECT_EQ(study.State().Dial, StudyDial::Harmonics4);
  StudyState stiffer = study.State();
  stiffer.Structures[0].Stiffness = 1.0;
  study.Change("stiffer", stiffer);
  EXPECT_EQ(study.State().Dial, StudyDial::Harmonics4);
  StudyState byHand = study.State();
  byHand.Structures[0].Representation = TouchRepresentation::Facets;
  study.Change("by hand", byHand);
  EXPECT_EQ(study.State().Dial, StudyDial::ByHand);
  study.Undo();
  EXPECT_EQ(study.State().Dial, StudyDial::Harmonics4);
  study.Close();
}
} // namespace
} // namespace palpate
