#include "StudyPipeline.h"

#include "FitStructure.h"
#include "InputError.h"
#include "SegmentationFile.h"
#include "StudyCases.h"
#include "StudyHistory.h"
#include "StudyPhantoms.h"
#include "TestData.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::study_pipeline_test
{
namespace
{
using Kind = StudyStepState::Kind;
using Steps = std::vector<SceneStep>;

const Steps AllSteps{SceneStep::Volume,  SceneStep::Segmentation, SceneStep::Structures,
                     SceneStep::Surface, SceneStep::Samples,      SceneStep::Model,
                     SceneStep::Field,   SceneStep::Touch};

class StudyPipelineTest : public testing::Test
{
protected:
  // Requests a state and waits until everything is made.
  void Make(const StudyState& state)
  {
    this->Pipeline.Update(state);
    test::Settle(this->Jobs);
  }
  // Label 1 yields, and a label of the same file is an inclusion with id 9.
  StudyState Yielding(int inclusionLabel) const
  {
    StudyState state = this->Phantom.State();
    state.Structures[0].Representation = TouchRepresentation::Elastic;
    state.Structures[0].SetNumber("elements_across", 4.0);
    SceneStructure inclusion = test::StudyPhantom::Structure(
        inclusionLabel, TouchRepresentation::Automatic, state.SegmentationFile);
    inclusion.Id = 9;
    inclusion.IsVisible = false;
    inclusion.IsTouchable = false;
    inclusion.SetNumber("inclusion_kpa", 60.0);
    state.Structures.push_back(inclusion);
    return state;
  }
  // The steps that a structure needs.
  Steps WantedFor(int label) const
  {
    Steps wanted;
    for (const SceneStep step : {SceneStep::Surface, SceneStep::Samples, SceneStep::Model,
                                 SceneStep::Field, SceneStep::Touch})
    {
      if (this->Pipeline.StateOf(step, label).Is != Kind::NotWanted)
      {
        wanted.push_back(step);
      }
    }
    return wanted;
  }
  void ExpectUpToDate(const Steps& steps)
  {
    for (const SceneStep step : steps)
    {
      const StudyStepState state = this->Pipeline.StateOf(step);
      EXPECT_EQ(state.Is, Kind::UpToDate) << NameOf(step) << ": " << state.Message;
    }
  }
  std::shared_ptr<const FitResult> Model(int label) const
  {
    return this->Pipeline.Newest<FitResult>(SceneStep::Model, label);
  }

  test::StudyPhantom Phantom;
  StudyJobs Jobs;
  StudyPipeline Pipeline{Jobs};
};

TEST_F(StudyPipelineTest, MakesTheSameAsAFit)
{
  const StudyState state = this->Phantom.State();
  this->Make(state);
  this->ExpectUpToDate({SceneStep::Volume, SceneStep::Segmentation, SceneStep::Structures,
                        SceneStep::Surface, SceneStep::Samples, SceneStep::Model,
                        SceneStep::Touch});
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Field).Is, Kind::NotWanted);
  const Segmentation segmentation = ReadSegmentation(state.SegmentationFile);
  const FitResult whole =
      FitStructure(segmentation, segmentation.Find("1"), FitSettingsOf(state, state.Structures[0]));
  const auto made = this->Model(1);
  ASSERT_NE(made, nullptr);
  EXPECT_EQ(made->Radial()->Coefficients(), whole.Radial()->Coefficients());
  EXPECT_EQ(made->Dice, whole.Dice);
  EXPECT_EQ(made->ModelToMask.Mean, whole.ModelToMask.Mean);
  EXPECT_NE(this->Pipeline.Newest<TouchContact>(SceneStep::Touch, 1), nullptr);
}

TEST_F(StudyPipelineTest, MakesOnlyWhatARepresentationNeeds)
{
  const std::vector<std::pair<std::string, Steps>> cases{
      {TouchRepresentation::Harmonics,
       {SceneStep::Surface, SceneStep::Samples, SceneStep::Model, SceneStep::Touch}},
      {TouchRepresentation::Facets, {SceneStep::Surface, SceneStep::Touch}},
      {TouchRepresentation::SubVoxel, {SceneStep::Field, SceneStep::Touch}}};
  for (const auto& [representation, steps] : cases)
  {
    StudyState state = this->Phantom.State();
    state.Structures = {test::StudyPhantom::Structure(1, representation, state.SegmentationFile)};
    this->Make(state);
    EXPECT_EQ(this->WantedFor(1), steps);
    this->ExpectUpToDate(steps);
    state.Structures[0].IsTouchable = false;
    this->Make(state);
    // Voxels that are only displayed get a surface.
    EXPECT_EQ(this->WantedFor(1), representation == TouchRepresentation::SubVoxel
                                      ? Steps{SceneStep::Surface}
                                      : Steps(steps.begin(), steps.end() - 1));
  }
}

TEST_F(StudyPipelineTest, MakesDisplayIndependentlyOfTouch)
{
  struct Case
  {
    SceneAppearance Appearance;
    bool IsTouchable;
    Steps Wanted;
  };
  const Steps fields{SceneStep::Field, SceneStep::Touch};
  const std::vector<Case> cases{
      {SceneAppearance::Automatic, true, fields},
      {SceneAppearance::SubVoxel, true, fields},
      {SceneAppearance::Surface, true, {SceneStep::Surface, SceneStep::Field, SceneStep::Touch}},
      {SceneAppearance::ErrorMap,
       true,
       {SceneStep::Surface, SceneStep::Samples, SceneStep::Model, SceneStep::Field,
        SceneStep::Touch}},
      {SceneAppearance::Model, false, {SceneStep::Surface, SceneStep::Samples, SceneStep::Model}},
      {SceneAppearance::Surface, false, {SceneStep::Surface}},
      {SceneAppearance::SubVoxel, false, {SceneStep::Field}}};
  for (const Case& one : cases)
  {
    StudyState state = this->Phantom.State();
    state.Structures = {
        test::StudyPhantom::Structure(1, TouchRepresentation::SubVoxel, state.SegmentationFile)};
    state.Structures[0].Appearance = one.Appearance;
    state.Structures[0].IsTouchable = one.IsTouchable;
    this->Make(state);
    EXPECT_EQ(this->WantedFor(1), one.Wanted) << NameOf(one.Appearance);
    this->ExpectUpToDate(one.Wanted);
    state.Structures[0].IsVisible = false;
    this->Make(state);
    EXPECT_EQ(this->WantedFor(1), one.IsTouchable ? fields : Steps()) << NameOf(one.Appearance);
  }
}

TEST_F(StudyPipelineTest, MakesASharedProductOnce)
{
  StudyState state = this->Phantom.State();
  this->Make(state);
  const std::uint64_t started = this->Pipeline.StartedCount();
  for (const SceneAppearance appearance :
       {SceneAppearance::Model, SceneAppearance::Surface, SceneAppearance::ErrorMap})
  {
    state.Structures[0].Appearance = appearance;
    this->Make(state);
    EXPECT_EQ(this->Pipeline.StartedCount(), started) << NameOf(appearance);
  }
}

TEST_F(StudyPipelineTest, MakesNothingForWhatIsNeitherShownNorTouched)
{
  StudyState state = this->Phantom.State();
  state.Structures[0].IsVisible = false;
  state.Structures[0].IsTouchable = false;
  this->Make(state);
  EXPECT_EQ(this->Pipeline.StartedCount(), 2U); // the files
  EXPECT_TRUE(this->WantedFor(1).empty());
}

TEST_F(StudyPipelineTest, TouchesTheFieldIfHarmonicsRefuse)
{
  StudyState state = this->Phantom.State();
  state.Structures = {
      test::StudyPhantom::Structure(2, TouchRepresentation::Automatic, state.SegmentationFile)};
  this->Make(state);
  const StudyStepState samples = this->Pipeline.StateOf(SceneStep::Samples);
  EXPECT_EQ(samples.Is, Kind::Replaced);
  EXPECT_EQ(samples.Message.rfind(
                "label 2: touched by its sub-voxel field, because it is not star-shaped: ", 0),
            0U)
      << samples.Message;
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Model).Message, samples.Message);
  EXPECT_EQ(this->Pipeline.Advice(), std::vector<std::string>{samples.Message});
  this->ExpectUpToDate({SceneStep::Surface, SceneStep::Field, SceneStep::Touch});
  // An explicit choice is refused and not replaced.
  state.Structures[0].Representation = TouchRepresentation::Harmonics;
  this->Make(state);
  const StudyStepState touch = this->Pipeline.StateOf(SceneStep::Touch);
  EXPECT_EQ(touch.Is, Kind::Failed);
  EXPECT_NE(touch.Message.find("is not star-shaped"), std::string::npos) << touch.Message;
  EXPECT_TRUE(this->Pipeline.Advice().empty());
}

TEST_F(StudyPipelineTest, DoesNotReplaceAnExplicitlyDisplayedModel)
{
  StudyState state = this->Phantom.State();
  state.Structures = {
      test::StudyPhantom::Structure(2, TouchRepresentation::Automatic, state.SegmentationFile)};
  state.Structures[0].Appearance = SceneAppearance::ErrorMap;
  this->Make(state);
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Model).Is, Kind::Failed);
  this->ExpectUpToDate({SceneStep::Field, SceneStep::Touch});
}

TEST_F(StudyPipelineTest, ShowsTheSurfaceIfHarmonicsRefuseAndTouchIsOff)
{
  StudyState state = this->Phantom.State();
  state.Structures = {
      test::StudyPhantom::Structure(2, TouchRepresentation::Automatic, state.SegmentationFile)};
  state.Structures[0].IsTouchable = false;
  this->Make(state);
  EXPECT_EQ(this->WantedFor(2), (Steps{SceneStep::Surface, SceneStep::Samples, SceneStep::Model}));
  ASSERT_EQ(this->Pipeline.Advice().size(), 1U);
  EXPECT_EQ(this->Pipeline.Advice()[0].rfind("label 2: displayed as the surface of its mask, ", 0),
            0U)
      << this->Pipeline.Advice()[0];
}

// A missing label has no replacement.
TEST_F(StudyPipelineTest, FailsWithoutReplacement)
{
  StudyState state = this->Phantom.State();
  state.Structures = {
      test::StudyPhantom::Structure(77, TouchRepresentation::Automatic, state.SegmentationFile)};
  this->Make(state);
  for (const SceneStep step : {SceneStep::Surface, SceneStep::Model, SceneStep::Field})
  {
    EXPECT_EQ(this->Pipeline.StateOf(step).Is, Kind::Failed) << NameOf(step);
  }
  EXPECT_TRUE(this->Pipeline.Advice().empty());
}

TEST_F(StudyPipelineTest, FailedStructureStopsNoOther)
{
  StudyState state = this->Phantom.State();
  state.Structures.push_back(
      test::StudyPhantom::Structure(3, TouchRepresentation::Harmonics, state.SegmentationFile));
  state.Structures.push_back(
      test::StudyPhantom::Structure(77, TouchRepresentation::Harmonics, state.SegmentationFile));
  this->Make(state);
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Touch, 1).Is, Kind::UpToDate);
  EXPECT_NE(this->Pipeline.StateOf(SceneStep::Surface, 3).Message.find("label 3 has only"),
            std::string::npos)
      << this->Pipeline.StateOf(SceneStep::Surface, 3).Message;
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Structures, 77).Is, Kind::Failed);
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Structures).Is, Kind::Failed);
}

// The degree affects only the model, the centre also the samples, the smoothing everything.
TEST_F(StudyPipelineTest, RemakesOnlyDependentProducts)
{
  StudyState state = this->Phantom.State();
  this->Make(state);
  std::uint64_t before = this->Pipeline.StartedCount();
  const auto started = [&]
  {
    this->Make(state);
    const std::uint64_t count = this->Pipeline.StartedCount() - before;
    before += count;
    return count;
  };
  EXPECT_EQ(started(), 0U);
  state.Structures[0].Degree = 6;
  EXPECT_EQ(started(), 3U); // model, touch, cost
  state.Fit.GivenCenterWorld = {-14.0, 0.0, 0.0};
  EXPECT_EQ(started(), 4U);
  state.Fit.Smoothing = 0.5;
  EXPECT_EQ(started(), 5U);
  state.Structures[0].Stiffness = 1.0;
  state.Structures[0].Color = {{1.0, 0.0, 0.0}};
  state.View.OverlayOpacity = 0.1;
  EXPECT_EQ(started(), 0U);
  state.Tool.Radius = 3.0;
  EXPECT_EQ(started(), 1U); // cost
}

TEST_F(StudyPipelineTest, MeasuresTheTickTimeOncePerContact)
{
  StudyState state = this->Phantom.State();
  state.Structures.push_back(
      test::StudyPhantom::Structure(2, TouchRepresentation::Harmonics, state.SegmentationFile));
  this->Make(state);
  const auto cost = this->Pipeline.Newest<TouchCost>(SceneStep::Cost, 1);
  ASSERT_NE(cost, nullptr);
  EXPECT_GT(cost->MedianNanoseconds, 0.0);
  EXPECT_TRUE(std::isfinite(cost->MedianNanoseconds));
  EXPECT_EQ(this->Pipeline.Newest<TouchCost>(SceneStep::Cost, 2), nullptr)
      << "a refused structure has none";
  StudyState other = state;
  other.Structures[0].Degree = 2;
  this->Make(other);
  EXPECT_NE(this->Pipeline.Newest<TouchCost>(SceneStep::Cost, 1), cost);
  this->Make(state);
  EXPECT_EQ(this->Pipeline.Newest<TouchCost>(SceneStep::Cost, 1), cost);
  state.Structures[0].IsTouchable = false;
  this->Make(state);
  EXPECT_EQ(this->Pipeline.Newest<TouchCost>(SceneStep::Cost, 1), nullptr);
}

TEST_F(StudyPipelineTest, FormerStateIsAvailableImmediately)
{
  StudyState state = this->Phantom.State();
  this->Make(state);
  const auto first = this->Model(1);
  StudyState other = state;
  other.Structures[0].Degree = 2;
  this->Make(other);
  EXPECT_NE(this->Model(1), first);
  const std::uint64_t started = this->Pipeline.StartedCount();
  this->Pipeline.Update(state);
  EXPECT_EQ(this->Model(1), first) << "without any delivery";
  EXPECT_EQ(this->Pipeline.StartedCount(), started);
}

TEST_F(StudyPipelineTest, ShowsThePreviousProductUntilTheNext)
{
  StudyState state = this->Phantom.State();
  this->Make(state);
  const auto first = this->Model(1);
  const std::uint64_t revision = this->Pipeline.Revision();
  state.Structures[0].Degree = 3;
  this->Pipeline.Update(state);
  EXPECT_EQ(this->Model(1), first);
  EXPECT_EQ(this->Pipeline.Revision(), revision);
  test::Settle(this->Jobs);
  EXPECT_EQ(this->Model(1)->Radial()->Degree(), 3);
  EXPECT_GT(this->Pipeline.Revision(), revision);
}

TEST_F(StudyPipelineTest, ForgetsHiddenStructures)
{
  StudyState state = this->Phantom.State();
  this->Make(state);
  state.Structures[0].IsVisible = false;
  state.Structures[0].IsTouchable = false;
  this->Pipeline.Update(state);
  EXPECT_EQ(this->Model(1), nullptr);
}

TEST_F(StudyPipelineTest, FailedFilesHaveTheCommandLinesMessages)
{
  test::WriteAll(this->Phantom.Folder / "broken.nii.gz", "no image");
  StudyState state = this->Phantom.State();
  for (const char* name : {"broken.nii.gz", "missing.nii.gz"})
  {
    state.SegmentationFile = this->Phantom.Folder / name;
    state.Structures[0].File = state.SegmentationFile;
    std::string message;
    try
    {
      ReadSegmentation(state.SegmentationFile);
    }
    catch (const InputError& error)
    {
      message = error.what();
    }
    this->Make(state);
    EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Segmentation).Message, message);
    EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Structures).Message, message);
    EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Touch).Message, message);
    EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Volume).Is, Kind::UpToDate);
  }
}

TEST_F(StudyPipelineTest, RereadsChangedFiles)
{
  StudyState state = this->Phantom.State();
  const auto file = this->Phantom.Folder / "mask.nii.gz";
  const std::string bytes = test::ReadAll(file);
  test::WriteAll(file, "broken");
  this->Make(state);
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Segmentation).Is, Kind::Failed);
  test::WriteAll(file, bytes);
  this->Make(state);
  this->ExpectUpToDate({SceneStep::Segmentation, SceneStep::Model});
}

TEST_F(StudyPipelineTest, CancelsUnneededJobs)
{
  this->Pipeline.Update(this->Phantom.State());
  EXPECT_FALSE(this->Jobs.IsIdle());
  this->Pipeline.Update(StudyState());
  EXPECT_TRUE(this->Jobs.IsIdle());
  EXPECT_EQ(this->Jobs.Deliver(), 0U);
}

TEST_F(StudyPipelineTest, CancelledStepWaitsForResume)
{
  const StudyState state = this->Phantom.State();
  this->Pipeline.Update(state);
  this->Pipeline.Cancel(SceneStep::Model);
  test::Settle(this->Jobs);
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Samples).Is, Kind::UpToDate);
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Model).Is, Kind::NeedsUpdate);
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Touch).Is, Kind::NeedsUpdate);
  this->Pipeline.Resume(SceneStep::Model);
  test::Settle(this->Jobs);
  this->ExpectUpToDate({SceneStep::Model, SceneStep::Touch});
}

TEST_F(StudyPipelineTest, ChangedInclusionMakesOnlyTheElasticityAgain)
{
  StudyState state = this->Yielding(1);
  SceneStructure& inclusion = state.Structures.back();
  this->Make(state);
  this->ExpectUpToDate({SceneStep::Model, SceneStep::Elasticity, SceneStep::Touch});
  const std::uint64_t before = this->Pipeline.StartedCount();
  inclusion.SetNumber("inclusion_kpa", 80.0);
  this->Make(state);
  EXPECT_EQ(this->Pipeline.StartedCount(), before + 3) << "elasticity, touch and cost";
  inclusion.SetNumber("inclusion_kpa", 60.0);
  this->Make(state);
  EXPECT_EQ(this->Pipeline.StartedCount(), before + 3) << "the earlier ones are kept";
}

TEST_F(StudyPipelineTest, ChangedInclusionElsewhereMakesNothingAgain)
{
  StudyState state = this->Yielding(2);
  this->Make(state);
  this->ExpectUpToDate({SceneStep::Elasticity, SceneStep::Touch});
  const auto placed = this->Pipeline.Newest<SceneInclusions>(SceneStep::Inclusions, 1);
  ASSERT_NE(placed, nullptr);
  ASSERT_EQ(placed->Shares.size(), 1U);
  EXPECT_GT(placed->Shares.front().second.Milliliters, 0.1);
  EXPECT_FALSE(placed->Has(9));
  const std::uint64_t before = this->Pipeline.StartedCount();
  state.Structures.back().SetNumber("inclusion_kpa", 80.0);
  this->Make(state);
  EXPECT_EQ(this->Pipeline.StartedCount(), before);
  this->ExpectUpToDate({SceneStep::Elasticity, SceneStep::Touch});
}

TEST_F(StudyPipelineTest, InclusionThatIsMissingFailsTheElasticity)
{
  const StudyState state = this->Yielding(7);
  this->Make(state);
  for (const SceneStep step : {SceneStep::Elasticity, SceneStep::Touch})
  {
    const StudyStepState found = this->Pipeline.StateOf(step, 1);
    EXPECT_EQ(found.Is, Kind::Failed) << NameOf(step);
    EXPECT_NE(found.Message.find("mask.nii.gz"), std::string::npos) << found.Message;
  }
}

TEST_F(StudyPipelineTest, DestructionWhileRunningLeavesNothingBehind)
{
  for (int deliveries = 0; deliveries < 6; ++deliveries)
  {
    StudyPipeline closed(this->Jobs);
    closed.Update(this->Phantom.State());
    for (int n = 0; n < deliveries && this->Jobs.WaitForResult(); ++n)
    {
      this->Jobs.Deliver();
    }
  }
  test::Settle(this->Jobs);
}

TEST_F(StudyPipelineTest, TinyCacheStillMakesEverything)
{
  StudyPipeline poor(this->Jobs, 1);
  poor.Update(this->Phantom.State());
  test::Settle(this->Jobs);
  EXPECT_EQ(poor.StateOf(SceneStep::Touch).Is, Kind::UpToDate);
  EXPECT_EQ(poor.StartedCount(), 7U);
}

// After any changes, undo steps and cancellations, once all is delivered, the pipeline holds the
// same products as a new one for the same state.
TEST_F(StudyPipelineTest, RandomChangesEndAsIfMadeDirectly)
{
  test::Random random(23);
  StudyHistory history(this->Phantom.State());
  const auto change = [&]
  {
    StudyState next = history.Current();
    next.Structures[0].Degree = test::RandomWhole(random, 1, 3);
    next.Structures[0].IsVisible = test::RandomChoice(random);
    next.Structures[0].IsTouchable = test::RandomChoice(random);
    next.Structures[0].Appearance = static_cast<SceneAppearance>(test::RandomWhole(random, 0, 5));
    next.Structures[0].Representation =
        SceneRepresentations().at(static_cast<std::size_t>(test::RandomWhole(random, 0, 3))).Name;
    next.Fit.Smoothing = test::RandomChoice(random) ? 0.0 : 1.0;
    next.VolumeFile = test::RandomChoice(random) ? "" : this->Phantom.Folder / "volume.nii.gz";
    history.Change("change", next);
  };
  for (int step = 0; step < 60; ++step)
  {
    const int what = test::RandomWhole(random, 0, 4);
    what < 3 ? change() : static_cast<void>(what == 3 ? history.Undo() : history.Redo());
    this->Pipeline.Update(history.Current());
    const SceneStep cancelled = AllSteps[random() % AllSteps.size()];
    this->Pipeline.Cancel(cancelled);
    if (test::RandomChoice(random) && this->Jobs.WaitForResult())
    {
      this->Jobs.Deliver();
    }
    this->Pipeline.Resume(cancelled);
    for (const SceneStep one : AllSteps) // states are available at any moment
    {
      this->Pipeline.StateOf(one);
    }
  }
  test::Settle(this->Jobs);
  StudyPipeline fresh(this->Jobs);
  fresh.Update(history.Current());
  test::Settle(this->Jobs);
  for (const SceneStep one : AllSteps)
  {
    EXPECT_EQ(this->Pipeline.StateOf(one).Is, fresh.StateOf(one).Is) << NameOf(one);
    EXPECT_EQ(this->Pipeline.StateOf(one).Message, fresh.StateOf(one).Message) << NameOf(one);
  }
}

TEST_F(StudyPipelineTest, MakesAProstateOfRealData)
{
  StudyState state;
  state.VolumeFile = StudyPath(test::DataPath("prostate/promise12_0_t2.nii.gz"));
  state.SegmentationFile = StudyPath(test::DataPath("prostate/promise12_0_label.nii.gz"));
  PALPATE_REQUIRE_FILE(state.VolumeFile);
  state.Structures.push_back(
      test::StudyPhantom::Structure(1, TouchRepresentation::Automatic, state.SegmentationFile));
  state.Structures[0].Degree = 12;
  this->Make(state);
  this->ExpectUpToDate({SceneStep::Volume, SceneStep::Model, SceneStep::Touch});
  EXPECT_GT(this->Model(1)->Dice, 0.95); // `palpate fit` gives 0.960
}

TEST_F(StudyPipelineTest, FurtherVolumeIsReadWhileItIsShown)
{
  StudyState state = this->Phantom.State();
  StudyVolume further;
  further.Id = 4;
  further.File = state.SegmentationFile; // any image will do
  further.IsVisible = false;
  state.Volumes = {further};
  this->Make(state);
  EXPECT_EQ(this->Pipeline.Newest<Volume>(SceneStep::Volume, 4), nullptr);
  state.Volumes[0].IsVisible = true;
  this->Make(state);
  const auto read = this->Pipeline.Newest<Volume>(SceneStep::Volume, 4);
  ASSERT_NE(read, nullptr);
  EXPECT_EQ(read->Source, further.File);
  EXPECT_NE(this->Pipeline.Newest<Volume>(SceneStep::Volume), read);
  state.Volumes.clear();
  this->Make(state);
  EXPECT_EQ(this->Pipeline.Newest<Volume>(SceneStep::Volume, 4), nullptr);
}

TEST_F(StudyPipelineTest, FurtherVolumeOfTheSameFileIsTheSameImage)
{
  StudyState state = this->Phantom.State();
  StudyVolume further;
  further.Id = 1;
  further.File = state.VolumeFile;
  state.Volumes = {further};
  this->Make(state);
  const auto first = this->Pipeline.Newest<Volume>(SceneStep::Volume);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(this->Pipeline.Newest<Volume>(SceneStep::Volume, 1), first);
}

TEST_F(StudyPipelineTest, UnreadableFurtherVolumeFailsAlone)
{
  StudyState state = this->Phantom.State();
  StudyVolume further;
  further.Id = 1;
  further.File = this->Phantom.Folder / "none.nii.gz";
  state.Volumes = {further};
  this->Make(state);
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Volume).Is, Kind::Failed);
  EXPECT_NE(this->Pipeline.StateOf(SceneStep::Volume).Message.find("none.nii.gz"),
            std::string::npos);
  EXPECT_NE(this->Pipeline.Newest<Volume>(SceneStep::Volume), nullptr);
  EXPECT_EQ(this->Pipeline.StateOf(SceneStep::Touch, 1).Is, Kind::UpToDate);
}
} // namespace
} // namespace palpate::study_pipeline_test
