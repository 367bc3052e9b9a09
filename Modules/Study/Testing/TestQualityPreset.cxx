#include "QualityPreset.h"
#include "Study.h"

#include "SteadyClock.h"
#include "StudyPhantoms.h"

#include <gtest/gtest.h>

namespace palpate::quality_preset_test
{
namespace
{
TEST(QualityPreset, StructureMatchesTheChosenPreset)
{
  SceneStructure structure = test::StudyPhantom::Structure(1, TouchRepresentation::Facets);
  EXPECT_EQ(PresetOf(structure), -1);
  for (int preset = 0; preset < QualityPresetCount; ++preset)
  {
    EXPECT_EQ(PresetOf(WithPreset(structure, preset)), preset);
  }
  EXPECT_EQ(WithPreset(structure, 1).Degree, 8);
  EXPECT_EQ(WithPreset(structure, 5).Interpolation, FieldInterpolation::TricubicBSpline);
  EXPECT_EQ(WithPreset(structure, 5).Degree, structure.Degree) << "the degree of the display";
}

TEST(QualityPreset, AppliesToLabelsOnly)
{
  SceneStructure model;
  model.File = "model.json";
  EXPECT_TRUE(WithPreset(model, 3) == model);
}

TEST(QualityPreset, StructuresThatYieldKeepYielding)
{
  SceneSettings scene;
  const SceneStructure soft = test::StudyPhantom::Structure(1, TouchRepresentation::Elastic);
  EXPECT_TRUE(WithPreset(soft, 3) == soft);
  const SceneStructure one = test::StudyPhantom::Structure(2, TouchRepresentation::Facets);
  scene.Structures = {soft, WithPreset(one, 2)};
  EXPECT_EQ(PresetOf(scene), 2);
}

TEST(QualityPreset, SceneMatchesThePresetOfAllTouchableLabels)
{
  SceneSettings scene;
  EXPECT_EQ(PresetOf(scene), -1);
  const SceneStructure one = test::StudyPhantom::Structure(1, TouchRepresentation::Facets);
  scene.Structures = {WithPreset(one, 2), WithPreset(one, 2)};
  EXPECT_EQ(PresetOf(scene), 2);
  scene.Structures.push_back(WithPreset(one, 4));
  EXPECT_EQ(PresetOf(scene), -1);
  scene.Structures.back().IsTouchable = false;
  EXPECT_EQ(PresetOf(scene), 2);
}

TEST(QualityReport, NumbersAreOneLine)
{
  QualityLine one;
  one.Title = "liver";
  one.Settings = "harmonics of degree 8";
  QualityLine other = one;
  EXPECT_EQ(TextOf(one), "liver: harmonics of degree 8");
  EXPECT_EQ(QualityNumbersText({one}, 0.0), "Tick: not known yet. Error: not known yet.");
  one.TickMicroseconds = 0.31;
  one.ErrorMillimeters = 0.4;
  other.TickMicroseconds = 1.2;
  other.ErrorMillimeters = 0.1;
  EXPECT_EQ(TextOf(one), "liver: harmonics of degree 8, 0.31 \u00B5s, 0.4 mm");
  EXPECT_EQ(QualityNumbersText({one, other}, 3.0),
            "Tick: 1.2 \u00B5s expected, 3 \u00B5s measured. Error: 0.4 mm expected.");
  EXPECT_EQ(QualityNumbersText({}, 3.0), "Tick: 3 \u00B5s measured. Error: not known yet.");
  one.MeasuringFraction = 0.25;
  EXPECT_EQ(TextOf(one), "liver: harmonics of degree 8, 0.31 \u00B5s, 0.4 mm, measuring (25 %)");
  EXPECT_EQ(QualityNumbersText({one, other}, 0.0),
            "Tick: 1.2 \u00B5s expected. Error: 0.4 mm expected. Measuring: 1 to go.");
}

class StudyQuality : public testing::Test
{
protected:
  void SetUp() override { this->Open.Change("open", this->Phantom.State()); }
  void Settle()
  {
    while (this->Open.Jobs().WaitForResult())
    {
      this->Open.Deliver();
    }
  }

  test::StudyPhantom Phantom;
  SteadyClock Clock;
  Study Open{Clock};
};

TEST_F(StudyQuality, IsMeasuredOnRequestAndRecommended)
{
  StudyState manual = this->Open.State();
  manual.Structures.front() = WithPreset(manual.Structures.front(), 0);
  manual.Structures.front().Degree = 5; // of no preset, so that each one is a change
  this->Open.Change("a degree of its own", manual);
  this->Settle();
  EXPECT_FALSE(this->Open.QualityLines().at(0).TickMicroseconds.has_value());
  this->Open.MeasureQuality();
  EXPECT_TRUE(this->Open.IsMeasuringQuality());
  this->Settle();
  const QualityLine line = this->Open.QualityLines().at(0);
  EXPECT_EQ(std::count(line.Presets.begin(), line.Presets.end(), '\n'), QualityPresetCount - 1);
  EXPECT_EQ(line.Problem, "");
  this->Open.UseRecommendedQuality();
  EXPECT_GE(PresetOf(this->Open.State()), 0);
  EXPECT_GT(*this->Open.QualityLines().at(0).TickMicroseconds, 0.0);
  EXPECT_EQ(this->Open.History().UndoText(), "Use the recommended quality");
}

TEST_F(StudyQuality, IsUnknownForAnotherTool)
{
  this->Open.MeasureQuality();
  this->Settle();
  StudyState next = this->Open.State();
  next.Tool.Radius = 1.0;
  this->Open.Change("another tool", next);
  EXPECT_EQ(this->Open.QualityLines().at(0).Presets, "");
}

TEST_F(StudyQuality, ReportsWhyItCannotBeMeasured)
{
  StudyState next = this->Open.State();
  next.Tool.Radius = -1.0;
  this->Open.Change("no tool", next);
  this->Open.MeasureQuality();
  this->Settle();
  EXPECT_NE(this->Open.QualityLines().at(0).Problem, "");
}
} // namespace
} // namespace palpate::quality_preset_test
