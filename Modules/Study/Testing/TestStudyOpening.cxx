#include "StudyOpening.h"

#include "ManualClock.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "SceneFile.h"
#include "StudyPhantoms.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::study_opening_test
{
namespace
{
RealtimeRequest Ordinary()
{
  RealtimeRequest request;
  request.Priority = 0;
  return request;
}

class StudyOpeningTest : public testing::Test
{
protected:
  StudyOpening::Outcome Count()
  {
    return {[this] { ++this->Done; },
            [this](const std::string& message)
            {
              this->Problem = message;
              ++this->Failed;
            }};
  }
  void Settle() { test::Settle(this->Open.Jobs()); }
  // A study of the phantom.
  void OpenPhantom()
  {
    this->Files.OpenVolume(this->Volume, {}, this->Count());
    this->Settle(); // the order of two that are read at once is open
    this->Files.OpenSegmentation(this->Mask, this->Count());
    while (this->Open.Jobs().WaitForResult())
    {
      this->Open.Deliver();
    }
  }
  std::filesystem::path WithBytes(const std::string& name, const std::string& bytes)
  {
    const auto file = this->Phantom.Folder / name;
    test::WriteAll(file, bytes);
    return file;
  }

  test::StudyPhantom Phantom;
  std::filesystem::path Volume = this->Phantom.Folder / "volume.nii.gz";
  std::filesystem::path Mask = this->Phantom.Folder / "mask.nii.gz";
  ManualClock Time;
  Study Open{this->Time, Ordinary()};
  StudyOpening Files{this->Open};
  int Done = 0;
  int Failed = 0;
  std::string Problem;
};

TEST_F(StudyOpeningTest, NothingChangesBeforeTheFileIsRead)
{
  this->Files.OpenVolume(this->Volume, {}, this->Count());
  EXPECT_TRUE(this->Files.IsReading());
  EXPECT_NE(this->Files.StateOf(SceneStep::Volume).Is, StudyStepState::Kind::NotWanted);
  EXPECT_EQ(this->Files.StateOf(SceneStep::Segmentation).Is, StudyStepState::Kind::NotWanted);
  EXPECT_EQ(this->Open.State(), StudyState());
  this->Settle();
  EXPECT_FALSE(this->Files.IsReading());
  EXPECT_EQ(this->Files.StateOf(SceneStep::Volume).Is, StudyStepState::Kind::NotWanted);
  EXPECT_EQ(this->Open.State().VolumeFile, this->Volume);
  EXPECT_EQ(this->Open.History().UndoText(), "Open the volume volume.nii.gz");
  EXPECT_EQ(this->Done, 1);
  EXPECT_EQ(this->Failed, 0);
}

TEST_F(StudyOpeningTest, WhatWasReadIsNotReadAgain)
{
  this->Files.OpenVolume(this->Volume, {}, this->Count());
  this->Settle();
  EXPECT_EQ(this->Open.Pipeline().StateOf(SceneStep::Volume).Is, StudyStepState::Kind::UpToDate);
  EXPECT_EQ(this->Open.Pipeline().StartedCount(), 0U);
}

TEST_F(StudyOpeningTest, SegmentationComesWithItsStructuresInOneStep)
{
  this->OpenPhantom();
  EXPECT_EQ(this->Open.State().Structures.size(), 3U);
  EXPECT_EQ(this->Open.History().UndoText(), "Open the segmentation mask.nii.gz");
  this->Open.Undo();
  EXPECT_TRUE(this->Open.State().Structures.empty());
  EXPECT_EQ(this->Open.State().VolumeFile, this->Volume);
}

TEST_F(StudyOpeningTest, FileThatCannotBeReadChangesNothing)
{
  this->OpenPhantom();
  const StudyState before = this->Open.State();
  const std::string undo = this->Open.History().UndoText();
  const std::string half = ReadWholeFile(this->Volume, 1 << 24).substr(0, 400);
  const auto expectNothing = [&](const std::filesystem::path& file)
  {
    this->Settle();
    EXPECT_FALSE(this->Files.IsReading());
    EXPECT_NE(this->Problem.find(file.filename().string()), std::string::npos) << this->Problem;
    EXPECT_EQ(this->Open.State(), before) << file;
    EXPECT_EQ(this->Open.History().UndoText(), undo) << file;
    EXPECT_EQ(this->Open.Pipeline().StateOf(SceneStep::Segmentation).Is,
              StudyStepState::Kind::UpToDate);
  };
  for (const auto& file :
       {this->WithBytes("text.nii.gz", "no image"), this->WithBytes("none.nrrd", ""),
        this->WithBytes("cut.nii.gz", half), this->Phantom.Folder / "absent.nii"})
  {
    this->Files.OpenVolume(file, {}, this->Count());
    expectNothing(file);
    this->Files.OpenSegmentation(file, this->Count());
    expectNothing(file);
  }
  for (const auto& file : {this->WithBytes("bad.stl", "solid"), this->WithBytes("none.ply", ""),
                           this->WithBytes("bad.json", "{}"), this->WithBytes("bad.coef", "x")})
  {
    this->Files.AddStructure(file, this->Count());
    expectNothing(file);
  }
  const auto scene = this->WithBytes("bad.scene.json", "{");
  this->Files.OpenScene(scene, this->Count());
  expectNothing(scene);
  EXPECT_EQ(this->Done, 2) << "the phantom's files";
  EXPECT_EQ(this->Failed, 13);
}

TEST_F(StudyOpeningTest, CancelledFileChangesNothing)
{
  this->Files.OpenVolume(this->Volume, {}, this->Count());
  this->Files.OpenSegmentation(this->Mask, this->Count());
  this->Files.Cancel(SceneStep::Volume);
  EXPECT_TRUE(this->Files.IsReading());
  this->Files.Cancel();
  EXPECT_FALSE(this->Files.IsReading());
  this->Settle();
  EXPECT_EQ(this->Open.State(), StudyState());
  EXPECT_EQ(this->Done + this->Failed, 0);
}

TEST_F(StudyOpeningTest, SceneIsAddedToWhatIsOpen)
{
  this->OpenPhantom();
  StudyState own = this->Open.State();
  own.Fit.Degree = 7;
  this->Open.Change("Change the degree", own);
  const RadialModel sphere(0, {8.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero());
  WriteModel(this->Phantom.Folder / "ball.json", {sphere, {}});
  SceneSettings scene;
  scene.Structures.resize(2);
  scene.Structures[0].File = this->Phantom.Folder / "ball.json";
  scene.Structures[1].File = this->Volume;
  scene.Structures[1].Iso = 350.0;
  scene.Structures[1].WithinFile = this->Mask;
  scene.Structures[1].WithinLabel = "1";
  scene.Tool.Radius = 1.5;
  const auto file =
      this->WithBytes("case.scene.json", SceneText(scene, this->Phantom.Folder.Path()));
  this->Files.OpenScene(file, this->Count());
  this->Settle();
  const StudyState& state = this->Open.State();
  ASSERT_EQ(state.Structures.size(), 5U) << this->Problem;
  EXPECT_EQ(state.Structures[1], own.Structures[1]);
  EXPECT_EQ(state.Structures[3].File, this->Phantom.Folder / "ball.json");
  EXPECT_EQ(state.Structures[4].WithinFile, this->Mask);
  EXPECT_EQ(state.Tool.Radius, 1.5);
  EXPECT_EQ(state.Fit.Degree, 7) << "that of the own structures";
  EXPECT_EQ(this->Open.History().UndoText(), "Open the scene case.scene.json");
  this->Open.Undo();
  EXPECT_EQ(this->Open.State(), own);
}

TEST_F(StudyOpeningTest, FurtherVolumeIsAddedOverTheFirst)
{
  this->Files.AddVolume(this->Volume, {}, this->Count());
  this->Settle();
  EXPECT_EQ(this->Open.State().VolumeFile, this->Volume) << "there was none";
  EXPECT_TRUE(this->Open.State().Volumes.empty());
  this->Files.AddVolume(this->Mask, {}, this->Count());
  this->Settle();
  this->Files.AddVolume(this->Volume, {}, this->Count());
  this->Settle();
  const auto& added = this->Open.State().Volumes;
  ASSERT_EQ(added.size(), 2U);
  EXPECT_EQ(added[0].File, this->Mask);
  EXPECT_EQ(added[1].File, this->Volume);
  EXPECT_NE(added[0].Id, added[1].Id);
  EXPECT_EQ(this->Open.History().UndoText(), "Add the volume volume.nii.gz");
  EXPECT_EQ(this->Done, 3);
}

TEST_F(StudyOpeningTest, FurtherVolumeThatCannotBeReadChangesNothing)
{
  this->OpenPhantom();
  const StudyState before = this->Open.State();
  this->Files.AddVolume(this->WithBytes("bad.nii.gz", "no image"), {}, this->Count());
  this->Settle();
  EXPECT_EQ(this->Open.State(), before);
  EXPECT_EQ(this->Failed, 1);
}
} // namespace
} // namespace palpate::study_opening_test
