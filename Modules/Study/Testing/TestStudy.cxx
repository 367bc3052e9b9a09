#include "Study.h"

#include "InputError.h"
#include "ManualClock.h"
#include "SceneContacts.h"
#include "SegmentColor.h"
#include "StructureColor.h"
#include "StudyCases.h"
#include "StudyFile.h"
#include "StudyPhantoms.h"
#include "StudyStructures.h"
#include "TouchRecorder.h"
#include "WholeFile.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <thread>

namespace palpate::study_test
{
namespace
{
RealtimeRequest Ordinary()
{
  RealtimeRequest request;
  request.Priority = 0;
  return request;
}

class StudyTest : public testing::Test
{
protected:
  void OpenFiles()
  {
    this->Open.OpenVolume(this->Phantom.Folder / "volume.nii.gz");
    this->Open.OpenSegmentation(this->Phantom.Folder / "mask.nii.gz");
  }
  void Settle()
  {
    while (this->Open.Jobs().WaitForResult())
    {
      this->Open.Deliver();
    }
  }
  // Changes the degree of the first structure, as the user would.
  void ChangeDegree(int degree)
  {
    StudyState next = this->Open.State();
    next.Structures.at(0).Degree = degree;
    this->Open.Change("Change the degree to " + std::to_string(degree), next);
  }

  test::StudyPhantom Phantom;
  ManualClock Time;
  Study Open{this->Time, Ordinary()};
};

TEST_F(StudyTest, SegmentationAndItsStructuresAreOneStep)
{
  this->OpenFiles();
  EXPECT_TRUE(this->Open.State().Structures.empty());
  this->Settle();
  ASSERT_EQ(this->Open.State().Structures.size(), 3U);
  EXPECT_EQ(this->Open.State().Structures[1].Id, 2);
  EXPECT_EQ(TitleOf(this->Open.State().Structures[1]), "label 2");
  EXPECT_EQ(this->Open.Pipeline().StateOf(SceneStep::Touch, 1).Is, StudyStepState::Kind::UpToDate);
  const StudyState opened = this->Open.State();
  EXPECT_EQ(this->Open.History().UndoText(), "Open the segmentation mask.nii.gz");
  this->Open.Undo();
  EXPECT_TRUE(this->Open.State().SegmentationFile.empty());
  this->Open.Redo();
  EXPECT_EQ(this->Open.State(), opened);
}

TEST_F(StudyTest, AddsStructuresOfAFurtherSegmentationInOneStep)
{
  this->OpenFiles();
  this->Settle();
  const StudyState before = this->Open.State();
  const auto lesion = this->Phantom.Folder / "lesion.nii.gz";
  std::filesystem::copy(this->Phantom.Folder / "mask.nii.gz", lesion);
  const auto fail = [](const std::string& message) { ADD_FAILURE() << message; };
  this->Open.AddSegmentation(lesion, fail);
  EXPECT_TRUE(this->Open.IsAddingSegmentation());
  this->Settle();
  EXPECT_FALSE(this->Open.IsAddingSegmentation());
  const StudyState added = this->Open.State();
  ASSERT_EQ(added.Structures.size(), 6U);
  EXPECT_EQ(added.SegmentationFile, before.SegmentationFile);
  EXPECT_EQ(added.Structures[3].File, lesion);
  EXPECT_EQ(added.Structures[3].Labels, std::vector<std::string>{"1"});
  EXPECT_GT(added.Structures[3].Id, 3) << "the label's number is taken";
  EXPECT_TRUE(added.Structures[3].IsVisible && !added.Structures[3].IsTouchable);
  EXPECT_EQ(TitleOf(added.Structures[3]), "lesion, label 1") << "label 1 is another";
  for (std::size_t one = 0; one < added.Structures.size(); ++one)
  {
    for (std::size_t other = 0; other < one; ++other)
    {
      const auto& a = added.Structures[one].Color;
      const auto& b = added.Structures[other].Color;
      EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 0.1) << one << ", " << other;
      EXPECT_NE(TitleOf(added.Structures[one]), TitleOf(added.Structures[other]));
    }
  }
  EXPECT_EQ(added.Structures.front().Color, before.Structures.front().Color);
  this->Open.Save(this->Phantom.Folder / "a.palpate.json");
  EXPECT_EQ(ReadStudy(this->Phantom.Folder / "a.palpate.json"), added);
  this->Open.Undo();
  EXPECT_EQ(this->Open.State(), before);
  this->Open.Redo();
  EXPECT_EQ(this->Open.State(), added);
  this->Open.AddSegmentation(lesion, fail);
  this->Settle();
  EXPECT_EQ(this->Open.State(), added) << "each label once";
}

TEST(StructuresOfSegmentation, OnlyOneIsNamedAfterItsFileUnlessItHasAName)
{
  StudyState state;
  state.SegmentationFile = "/liver.nii.gz";
  Segmentation read;
  read.Segments.resize(1);
  read.Segments[0].Label = read.Segments[0].Value = 1;
  EXPECT_EQ(WithStructuresOf(state, read).Structures.front().Name, "liver");
  read.Segments[0].Name = "Hepar";
  EXPECT_EQ(WithStructuresOf(state, read).Structures.front().Name, "Hepar");
}

TEST(AddedStructuresOfSegmentations, NamesAreTakenOnce)
{
  Segmentation read;
  for (const int label : {1, 2})
  {
    Segment segment;
    segment.Label = segment.Value = label;
    segment.Name = label == 1 ? "Lesion" : "";
    read.Segments.push_back(segment);
  }
  StudyState state;
  for (const char* file : {"/a.nii.gz", "/b.nii.gz", "/c.nii.gz"})
  {
    state = WithAddedStructuresOf(state, file, read);
  }
  std::vector<std::string> titles;
  for (const SceneStructure& structure : state.Structures)
  {
    titles.push_back(TitleOf(structure));
  }
  EXPECT_EQ(titles, (std::vector<std::string>{"Lesion", "label 2", "Lesion (2)", "b, label 2",
                                              "Lesion (3)", "c, label 2"}));
  read.Segments.erase(read.Segments.begin());
  state = WithAddedStructuresOf(state, "/d/b.nii.gz", read);
  EXPECT_EQ(TitleOf(state.Structures.back()), "b") << "the file's only structure";
  state = WithAddedStructuresOf(state, "/e/b.nii.gz", read);
  EXPECT_EQ(TitleOf(state.Structures.back()), "b (2)");
}

TEST(AddedStructuresOfSegmentations, ColoursStayApart)
{
  Segmentation read;
  Segment segment;
  segment.Label = segment.Value = 1;
  segment.Color = {{1.0, 0.0, 0.0}};
  read.Segments.push_back(segment);
  StudyState state;
  for (int file = 0; file < 8; ++file)
  {
    state = WithAddedStructuresOf(state, "/" + std::to_string(file) + ".nii.gz", read);
  }
  ASSERT_EQ(state.Structures.size(), 8U);
  EXPECT_EQ(state.Structures.front().Color, segment.Color) << "its own where it is free";
  for (std::size_t one = 0; one < 8; ++one)
  {
    for (std::size_t other = 0; other < one; ++other)
    {
      const auto& a = state.Structures[one].Color;
      const auto& b = state.Structures[other].Color;
      EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 0.2) << one << ", " << other;
    }
  }
}

// Each file without colours begins with the same orange.
TEST(AddedStructuresOfSegmentations, StructuresOfSeveralFilesNeverGetTheSameColourByAccident)
{
  Segmentation read;
  for (const int label : {1, 2, 3})
  {
    Segment segment;
    segment.Label = segment.Value = label;
    segment.Color = DefaultSegmentColor(label);
    read.Segments.push_back(segment);
  }
  const auto expectApart = [](const StudyState& state)
  {
    for (const SceneStructure& one : state.Structures)
    {
      for (const SceneStructure& other : state.Structures)
      {
        if (one.File != other.File)
        {
          EXPECT_GT(std::hypot(one.Color[0] - other.Color[0], one.Color[1] - other.Color[1],
                               one.Color[2] - other.Color[2]),
                    0.1)
              << TitleOf(one) << ", " << TitleOf(other);
        }
      }
    }
  };
  StudyState replaced = WithAddedStructuresOf({}, "/a.nii.gz", read);
  replaced = WithAddedStructuresOf(replaced, "/b.nii.gz", read);
  expectApart(replaced);
  replaced.SegmentationFile = "/c.nii.gz";
  replaced = WithStructuresOf(replaced, read);
  ASSERT_EQ(replaced.Structures.size(), 9U);
  expectApart(replaced);
  SceneSettings scene;
  for (const int file : {1, 2, 3})
  {
    SceneStructure structure;
    structure.Id = file;
    structure.File = "/" + std::to_string(file) + ".nii.gz";
    structure.Labels = {"1"};
    structure.Color = DefaultSegmentColor(1);
    scene.Structures.push_back(structure);
  }
  expectApart(WithScene({}, scene));
  scene.Structures[0].Color = scene.Structures[1].Color = {{1.0, 0.0, 0.0}};
  EXPECT_EQ(WithScene({}, scene).Structures[1].Color, scene.Structures[0].Color)
      << "on purpose they may";
}

TEST(AddedStructuresOfSegmentations, EvenManyFilesHaveColoursOfTheirOwn)
{
  Segmentation read;
  Segment segment;
  segment.Label = segment.Value = 1;
  read.Segments.push_back(segment);
  StudyState state;
  std::set<std::array<double, 3>> colors;
  for (int file = 0; file < 60; ++file)
  {
    state = WithAddedStructuresOf(state, "/" + std::to_string(file) + ".nii.gz", read);
    colors.insert(state.Structures.back().Color);
  }
  EXPECT_EQ(colors.size(), 60U);
}

TEST_F(StudyTest, FirstAddedSegmentationIsThatOfTheSlices)
{
  const auto mask = this->Phantom.Folder / "mask.nii.gz";
  this->Open.AddSegmentation(mask, [](const std::string&) {});
  this->Settle();
  EXPECT_EQ(this->Open.State().SegmentationFile, mask);
  EXPECT_EQ(this->Open.State().Structures.size(), 3U);
}

TEST_F(StudyTest, SegmentationThatCannotBeAddedIsReported)
{
  this->OpenFiles();
  this->Settle();
  const StudyState before = this->Open.State();
  std::string problem;
  this->Open.AddSegmentation(this->Phantom.Folder / "missing.nii.gz",
                             [&problem](const std::string& message) { problem = message; });
  this->Settle();
  EXPECT_NE(problem.find("missing.nii.gz"), std::string::npos) << problem;
  EXPECT_EQ(this->Open.State(), before);
  EXPECT_FALSE(this->Open.IsAddingSegmentation());
}

TEST_F(StudyTest, NewStudyForgetsASegmentationThatIsBeingAdded)
{
  this->Open.AddSegmentation(this->Phantom.Folder / "mask.nii.gz", [](const std::string&) {});
  this->Open.New();
  this->Settle();
  EXPECT_EQ(this->Open.State(), StudyState());
}

TEST_F(StudyTest, StructuresArriveAfterUndoAndRedo)
{
  this->OpenFiles();
  this->Open.Undo();
  this->Settle();
  this->Open.Redo();
  this->Settle();
  EXPECT_EQ(this->Open.State().Structures.size(), 3U);
}

TEST_F(StudyTest, RemovedStructuresStayRemoved)
{
  this->OpenFiles();
  this->Settle();
  StudyState next = this->Open.State();
  next.Structures.clear();
  this->Open.Change("Remove all structures", next);
  this->Settle();
  this->Open.Undo();
  this->Open.Redo();
  this->Settle();
  EXPECT_TRUE(this->Open.State().Structures.empty());
}

TEST(StudyStructures, ShowsOnlyTheFirstOfManyByDefault)
{
  Segmentation segmentation;
  for (int label = 1; label <= 20; ++label)
  {
    Segment segment;
    segment.Label = label;
    segmentation.Segments.push_back(segment);
  }
  const StudyState state = WithStructuresOf({}, segmentation);
  ASSERT_EQ(state.Structures.size(), 20U);
  for (const SceneStructure& structure : state.Structures)
  {
    EXPECT_EQ(structure.IsVisible, structure.Id == 1);
    EXPECT_EQ(structure.IsTouchable, structure.Id == 1);
  }
}

TEST(StudyStructures, BlackOfAFileIsReplaced)
{
  Segmentation segmentation;
  for (int label = 1; label <= 2; ++label)
  {
    Segment segment;
    segment.Label = label;
    segment.Color = {{0.0, 0.0, label == 1 ? 0.0 : 1.0}};
    segmentation.Segments.push_back(segment);
  }
  const StudyState state = WithStructuresOf({}, segmentation);
  EXPECT_EQ(state.Structures.at(0).Color, StructureColor({}, 1));
  EXPECT_EQ(state.Structures.at(1).Color, segmentation.Segments[1].Color);
}

TEST_F(StudyTest, OnlyOpenedFilesAreNoChange)
{
  this->OpenFiles();
  this->Settle();
  ASSERT_FALSE(this->Open.State().Structures.empty());
  EXPECT_FALSE(this->Open.History().IsChanged());
  this->Open.AddVolume(this->Open.State().VolumeFile);
  EXPECT_FALSE(this->Open.History().IsChanged());
  this->ChangeDegree(5);
  EXPECT_TRUE(this->Open.History().IsChanged());
  this->Open.OpenVolume(this->Open.State().VolumeFile, "1.2.3");
  EXPECT_TRUE(this->Open.History().IsChanged()) << "the degree is";
}

TEST_F(StudyTest, FileOpenedBesideASessionIsAChange)
{
  this->OpenFiles();
  this->Settle();
  this->Open.Save(this->Phantom.Folder / "case.palpate.json");
  this->Open.AddVolume(this->Open.State().VolumeFile);
  EXPECT_TRUE(this->Open.History().IsChanged());
}

TEST_F(StudyTest, SessionReopensAsSaved)
{
  this->OpenFiles();
  this->Settle();
  this->ChangeDegree(5);
  EXPECT_TRUE(this->Open.History().IsChanged());
  const auto file = this->Phantom.Folder / "case.palpate.json";
  this->Open.Save(file);
  EXPECT_FALSE(this->Open.History().IsChanged());
  const StudyState saved = this->Open.State();
  this->Open.New();
  EXPECT_EQ(this->Open.State(), StudyState());
  this->Open.Open(file);
  EXPECT_EQ(this->Open.File(), file);
  EXPECT_EQ(this->Open.State(), saved);
  EXPECT_FALSE(this->Open.History().CanUndo());
  this->Settle();
  EXPECT_EQ(this->Open.State(), saved);
  EXPECT_EQ(this->Open.Pipeline().Newest<FitResult>(SceneStep::Model, 1)->Radial()->Degree(), 5);
}

TEST_F(StudyTest, FailedOpenKeepsTheCurrentStudy)
{
  this->OpenFiles();
  this->Settle();
  const StudyState before = this->Open.State();
  test::WriteAll(this->Phantom.Folder / "bad.palpate.json", "{");
  EXPECT_THROW(this->Open.Open(this->Phantom.Folder / "bad.palpate.json"), InputError);
  EXPECT_EQ(this->Open.State(), before);
  EXPECT_TRUE(this->Open.History().CanUndo());
}

TEST_F(StudyTest, RelocatesMissingFile)
{
  this->OpenFiles();
  this->Settle();
  const auto file = this->Phantom.Folder / "case.palpate.json";
  this->Open.Save(file);
  const auto mask = this->Phantom.Folder / "mask.nii.gz";
  std::filesystem::rename(mask, this->Phantom.Folder / "moved.nii.gz");
  this->Open.Open(file);
  this->Settle();
  ASSERT_EQ(MissingFiles(this->Open.State()).size(), 1U);
  EXPECT_EQ(this->Open.Pipeline().StateOf(SceneStep::Segmentation).Is,
            StudyStepState::Kind::Failed);
  this->Open.RelocateFile(mask, this->Phantom.Folder / "moved.nii.gz");
  this->Settle();
  EXPECT_EQ(this->Open.Pipeline().StateOf(SceneStep::Touch, 1).Is, StudyStepState::Kind::UpToDate);
  EXPECT_EQ(this->Open.State().Structures.size(), 3U);
}

// Open, touch, refit while touching, stop.
TEST_F(StudyTest, TouchFollowsTheState)
{
  this->OpenFiles();
  this->Settle();
  this->Open.StartTouch();
  EXPECT_TRUE(this->Open.IsOpeningDevice());
  this->Settle();
  ASSERT_TRUE(this->Open.Touch().IsRunning()) << this->Open.TouchProblem();
  this->Open.Touch().MoveHand(Vector3(-15.0, 0.0, 5.0)); // in the sphere
  while (this->Open.Touch().Poll().TouchedId != 1)
  {
    std::this_thread::yield();
  }
  const std::uint64_t scene = this->Open.Touch().Poll().Newest.Scene;
  this->ChangeDegree(6);
  this->Settle();
  while (this->Open.Touch().Poll().Newest.Scene == scene)
  {
    std::this_thread::yield();
  }
  EXPECT_EQ(this->Open.TouchProblem(), "");
  this->Open.StopTouch();
  EXPECT_FALSE(this->Open.Touch().IsRunning());
}

// Touch and replay never run at the same time.
TEST_F(StudyTest, TouchAndReplayExcludeEachOther)
{
  this->OpenFiles();
  this->Settle();
  this->Open.StartTouch();
  this->Settle();
  ASSERT_TRUE(this->Open.Touch().IsRunning()) << this->Open.TouchProblem();
  const auto file = this->Phantom.Folder / "session.touch";
  TouchState touched;
  touched.Structure = 1;
  TouchRecorder recorder;
  ASSERT_TRUE(recorder.Start(file.string(), {}).IsOk());
  ASSERT_TRUE(recorder.Take(touched).IsOk());
  ASSERT_TRUE(recorder.Finish().IsOk());
  this->Open.OpenReplay(this->Phantom.Folder / "absent.touch");
  EXPECT_TRUE(this->Open.IsOpeningReplay());
  this->Settle();
  EXPECT_NE(this->Open.ReplayProblem().find("absent.touch"), std::string::npos);
  EXPECT_TRUE(this->Open.Touch().IsRunning()) << "a file that cannot be read ends nothing";
  this->Open.OpenReplay(file);
  this->Settle();
  ASSERT_NE(this->Open.Replay(), nullptr) << this->Open.ReplayProblem();
  EXPECT_FALSE(this->Open.Touch().IsRunning());
  const int second = this->Open.Contacts().at(1).Id;
  EXPECT_EQ(this->Open.PollReplay().TouchedId, second);
  EXPECT_EQ(this->Open.ReplayProblem(), "");
  // As left by a crashed program.
  const std::string bytes = ReadWholeFile(file, 1 << 20);
  test::WriteAll(this->Phantom.Folder / "cut.part", bytes + bytes.substr(0, 100));
  this->Open.OpenReplay(this->Phantom.Folder / "cut.part");
  this->Settle();
  EXPECT_NE(this->Open.Replay(), nullptr);
  EXPECT_NE(this->Open.ReplayProblem().find("left out"), std::string::npos);
  this->Open.OpenReplay(this->Phantom.Folder / "absent.touch");
  this->Settle();
  EXPECT_NE(this->Open.Replay(), nullptr) << "a file that cannot be read replaces nothing";
  this->Open.StartTouch();
  EXPECT_EQ(this->Open.Replay(), nullptr);
  this->Settle();
  EXPECT_TRUE(this->Open.Touch().IsRunning()) << this->Open.TouchProblem();
}

TEST_F(StudyTest, DraggedWorkspaceIsOneUndoableStep)
{
  this->OpenFiles();
  this->Settle();
  this->Open.MoveWorkspace(Vector3::Zero(), "drag");
  EXPECT_FALSE(this->Open.State().Placement.CenterWorld) << "none yet";
  this->Open.StartTouch();
  this->Settle();
  ASSERT_TRUE(this->Open.Touch().IsRunning()) << this->Open.TouchProblem();
  const Vector3 before = this->Open.Touch().Frame().CenterWorld;
  const Vector3 moved = before + Vector3(3.0, -4.0, 5.0);
  this->Open.MoveWorkspace(before + Vector3(1.0, 0.0, 0.0), "drag");
  this->Open.MoveWorkspace(moved, "drag");
  this->Open.EndGesture();
  EXPECT_EQ(this->Open.Touch().Frame().CenterWorld, moved);
  ASSERT_TRUE(this->Open.Undo());
  EXPECT_EQ(this->Open.Touch().Frame().CenterWorld, before);
  ASSERT_TRUE(this->Open.Redo());
  EXPECT_EQ(this->Open.Touch().Frame().CenterWorld, moved);
  this->Open.FitWorkspace();
  EXPECT_EQ(this->Open.Touch().Frame().CenterWorld, before);
  EXPECT_FALSE(this->Open.State().Placement.CenterWorld);
  ASSERT_TRUE(this->Open.Undo());
  EXPECT_EQ(this->Open.Touch().Frame().CenterWorld, moved);
}

TEST_F(StudyTest, NothingToTouchIsOverOnceThereIsSomething)
{
  this->Open.StartTouch();
  this->Settle();
  ASSERT_NE(this->Open.TouchProblem().find("nothing to touch"), std::string::npos);
  this->OpenFiles();
  this->Settle();
  ASSERT_FALSE(this->Open.Contacts().empty());
  EXPECT_EQ(this->Open.TouchProblem(), "");
}

TEST_F(StudyTest, ReportsWhyTouchCannotStart)
{
  this->Open.StartTouch();
  this->Settle();
  EXPECT_NE(this->Open.TouchProblem().find("nothing to touch"), std::string::npos);
  this->OpenFiles();
  this->Settle();
  StudyState next = this->Open.State();
  next.Device = "phantom";
  this->Open.Change("Choose the device", next);
  this->Open.StartTouch();
  this->Settle();
  EXPECT_NE(this->Open.TouchProblem().find("phantom"), std::string::npos)
      << this->Open.TouchProblem();
  EXPECT_FALSE(this->Open.Touch().IsRunning());
}

TEST_F(StudyTest, ClosingAtAnyMomentEndsEverything)
{
  for (int deliveries = 0; deliveries < 8; ++deliveries)
  {
    Study closed(this->Time, Ordinary());
    closed.OpenVolume(this->Phantom.Folder / "volume.nii.gz");
    closed.OpenSegmentation(this->Phantom.Folder / "mask.nii.gz");
    for (int n = 0; n < deliveries && closed.Jobs().WaitForResult(); ++n)
    {
      closed.Deliver();
    }
    closed.StartTouch();
    // Jobs of these small files end long before.
    EXPECT_TRUE(closed.Close(std::chrono::minutes(1)));
    EXPECT_FALSE(closed.Touch().IsRunning());
    EXPECT_EQ(closed.Deliver(), 0U);
  }
}

// After any sequence of steps, undoing and redoing all of them restores the states.
TEST_F(StudyTest, UndoAndRedoOfRandomStepsRestoreTheStates)
{
  this->OpenFiles();
  this->Settle();
  test::Random random(31);
  std::vector<StudyState> states{this->Open.State()};
  for (int step = 0; step < 20; ++step)
  {
    StudyState next = this->Open.State();
    SceneStructure& structure = next.Structures[random() % next.Structures.size()];
    structure.Degree = test::RandomWhole(random, 1, 4);
    structure.IsVisible = test::RandomChoice(random);
    structure.IsTouchable = test::RandomChoice(random);
    structure.Stiffness = test::RandomNumber(random, 0.1, 1.0);
    this->Open.Change("step", next);
    states.push_back(this->Open.State());
    if (test::RandomChoice(random) && this->Open.Jobs().WaitForResult())
    {
      this->Open.Deliver();
    }
  }
  for (std::size_t n = states.size(); n-- > 1;)
  {
    ASSERT_EQ(this->Open.State(), states[n]);
    this->Open.Undo();
  }
  for (std::size_t n = 1; n < states.size(); ++n)
  {
    this->Open.Redo();
    ASSERT_EQ(this->Open.State(), states[n]);
  }
}
} // namespace
} // namespace palpate::study_test
