// Structures of a range of the volume's values.
#include "InputError.h"
#include "ManualClock.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "Study.h"
#include "StudyFile.h"
#include "StudyPhantoms.h"
#include "StudyStructures.h"
#include "SurfaceFile.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::study_threshold_test
{
namespace
{
RealtimeRequest Ordinary()
{
  RealtimeRequest request;
  request.Priority = 0;
  return request;
}

// The phantom's volume is 700 within 16 mm of the origin; label 1 is a ball of 9 mm at x = -15 mm.
class StudyThresholdTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Open.OpenVolume(this->Phantom.Folder / "volume.nii.gz");
    this->Open.OpenSegmentation(this->Phantom.Folder / "mask.nii.gz");
    this->Settle();
  }
  void Settle()
  {
    while (this->Open.Jobs().WaitForResult())
    {
      this->Open.Deliver();
    }
  }
  const SceneStructure& Last() const { return this->Open.State().Structures.back(); }
  std::shared_ptr<const TouchContact> Contact()
  {
    return this->Open.Pipeline().Newest<TouchContact>(SceneStep::Touch, this->Last().Id);
  }
  std::string RefusalOf(const StudyThreshold& threshold)
  {
    try
    {
      this->Open.AddThreshold(threshold);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return {};
  }

  test::StudyPhantom Phantom;
  ManualClock Time;
  Study Open{this->Time, Ordinary()};
};

TEST_F(StudyThresholdTest, IsTouchedInsideItsLabelOnly)
{
  const StudyState before = this->Open.State();
  this->Open.AddThreshold({350.0, 900.0, 1, {}});
  this->Settle();
  EXPECT_EQ(this->Last().Iso, 350.0);
  EXPECT_EQ(this->Last().IsoUpper, 900.0);
  EXPECT_EQ(this->Last().WithinFile, before.SegmentationFile);
  EXPECT_EQ(this->Last().Name, "iso 350 to 900 in label 1");
  ASSERT_NE(this->Contact(), nullptr)
      << this->Open.Pipeline().StateOf(SceneStep::Field, this->Last().Id).Message;
  // A field's bounds are those of its bricks, which end up to 4 mm away.
  const Eigen::AlignedBox3d bounds = this->Contact()->Model->BoundsWorld();
  EXPECT_NEAR(bounds.min().x(), -16.0, 4.0) << "the border of the values";
  EXPECT_NEAR(bounds.max().x(), -6.0, 4.0) << "the border of the label";
  this->Open.Undo();
  EXPECT_EQ(this->Open.State(), before);
}

TEST_F(StudyThresholdTest, IsDrilledToALabelMap)
{
  this->Open.AddThreshold({350.0, 900.0, 0, "bone"});
  StudyState next = this->Open.State();
  next.Structures.back().Drill.Wear = 0.1;
  this->Open.Change("Drill it", next);
  this->Settle();
  ASSERT_NE(this->Contact(), nullptr);
  EXPECT_EQ(this->Last().Name, "bone");
  EXPECT_NE(this->Contact()->Drilled.Field, nullptr);
  EXPECT_EQ(this->Contact()->Drilled.Label, 1);
  EXPECT_EQ(this->Contact()->Drilled.Image->GetScalarType(), VTK_UNSIGNED_CHAR);
}

TEST_F(StudyThresholdTest, EmptyRangeFailsWithTheReason)
{
  this->Open.AddThreshold({100.0, 200.0, 0, {}});
  this->Settle();
  EXPECT_EQ(this->Contact(), nullptr);
  const StudyStepState field = this->Open.Pipeline().StateOf(SceneStep::Field, this->Last().Id);
  EXPECT_EQ(field.Is, StudyStepState::Kind::Failed);
  EXPECT_NE(field.Message.find("no voxel with a value from 100 to 200"), std::string::npos)
      << field.Message;
}

TEST_F(StudyThresholdTest, RefusesContradictions)
{
  const StudyState before = this->Open.State();
  EXPECT_NE(this->RefusalOf({5.0, 5.0, 0, {}}).find("above"), std::string::npos);
  EXPECT_NE(this->RefusalOf({std::nan(""), {}, 0, {}}).find("above"), std::string::npos);
  EXPECT_NE(this->RefusalOf({5.0, {}, 99, {}}).find("label"), std::string::npos);
  this->Open.AddIsoValue(350.0);
  EXPECT_NE(this->RefusalOf({5.0, {}, this->Last().Id, {}}).find("label"), std::string::npos)
      << "an iso-value has no label";
  this->Open.Undo();
  EXPECT_EQ(this->Open.State(), before);
  this->Open.New();
  EXPECT_NE(this->RefusalOf({5.0, {}, 0, {}}).find("no volume"), std::string::npos);
}

TEST_F(StudyThresholdTest, FurtherOnesCanBeToldApart)
{
  this->Open.AddIsoValue(350.0);
  const SceneStructure first = this->Last();
  this->Open.AddIsoValue(350.0);
  EXPECT_NE(this->Last().Id, first.Id);
  EXPECT_NE(this->Last().Name, first.Name);
  const auto& a = first.Color;
  const auto& b = this->Last().Color;
  EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 0.1);
}

TEST(StudyThresholds, TakeTheVolumesSeries)
{
  StudyState state;
  state.VolumeFile = "/ct";
  state.DicomSeries = "2";
  const SceneStructure structure = ThresholdStructure(state, {300.0, {}, 0, {}});
  EXPECT_EQ(structure.File, "/ct");
  EXPECT_EQ(structure.Series, "2");
}

TEST_F(StudyThresholdTest, StructuresOfEverySourceReopenAsSaved)
{
  const RadialModel sphere(0, {8.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero());
  WriteModel(this->Phantom.Folder / "ball.json", {sphere, {}});
  WriteSurface(this->Phantom.Folder / "ball.stl", DrawModel(sphere, 6));
  this->Open.AddStructure(this->Phantom.Folder / "ball.json");
  this->Open.AddStructure(this->Phantom.Folder / "ball.stl");
  this->Open.AddIsoValue(350.0);
  this->Open.AddThreshold({350.0, 900.0, 1, "bone of the left"});
  this->Settle();
  const StudyState saved = this->Open.State();
  ASSERT_EQ(saved.Structures.size(), 7U);
  const auto file = this->Phantom.Folder / "case.palpate.json";
  this->Open.Save(file);
  this->Open.New();
  this->Settle();
  this->Open.Open(file);
  this->Settle();
  EXPECT_EQ(this->Open.State(), saved);
  for (std::size_t s = 3; s < saved.Structures.size(); ++s)
  {
    const int id = saved.Structures[s].Id;
    EXPECT_EQ(this->Open.Pipeline().StateOf(SceneStep::Touch, id).Is,
              StudyStepState::Kind::UpToDate)
        << TitleOf(saved.Structures[s]);
  }
}

TEST_F(StudyThresholdTest, MovedLabelsAreFound)
{
  this->Open.AddThreshold({350.0, {}, 1, {}});
  StudyState state = this->Open.State();
  state.SegmentationFile.clear();
  state.Structures = {this->Last()};
  const auto mask = this->Phantom.Folder / "mask.nii.gz";
  const auto moved = this->Phantom.Folder / "moved.nii.gz";
  std::filesystem::rename(mask, moved);
  const auto missing = MissingFiles(state);
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing.front().Role, "segmentation");
  EXPECT_EQ(Relocate(state, mask, moved).Structures.front().WithinFile, moved);
}
} // namespace
} // namespace palpate::study_threshold_test
