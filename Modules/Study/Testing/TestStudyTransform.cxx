// Further volumes that are moved by a transform.
#include "InputError.h"
#include "ManualClock.h"
#include "Study.h"
#include "StudyPhantoms.h"
#include "TransformFile.h"
#include "VoxelValue.h"

#include <fstream>
#include <gtest/gtest.h>

namespace palpate::study_transform_test
{
namespace
{
RealtimeRequest OrdinaryPriority()
{
  RealtimeRequest request;
  request.Priority = 0;
  return request;
}

Eigen::Affine3d Turned()
{
  return Eigen::Translation3d(40.0, -7.0, 3.0) *
         Eigen::Affine3d(Eigen::AngleAxisd(0.5, Vector3(2.0, 1.0, -2.0).normalized()));
}

// The phantom's volume over itself: a ball of 16 mm at the origin.
class StudyTransformTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Open.OpenVolume(this->Phantom.Folder / "volume.nii.gz");
    this->Open.AddVolume(this->Phantom.Folder / "volume.nii.gz");
    WriteTransform(this->File, Turned());
    this->Settle();
  }
  void Settle()
  {
    while (this->Open.Jobs().WaitForResult())
    {
      this->Open.Deliver();
    }
  }
  void MoveVolume(const std::filesystem::path& transform)
  {
    this->Open.Change("Move", WithTransform(this->Open.State(), 1, transform));
  }
  double ValueAt(const Vector3& world)
  {
    const auto volume = this->Open.Pipeline().Newest<Volume>(SceneStep::Volume, 1);
    return VoxelValueAt(volume->Image, world).value_or(-1.0);
  }
  const StudyVolume& Further() const { return this->Open.State().Volumes.at(0); }

  test::StudyPhantom Phantom;
  std::filesystem::path File = this->Phantom.Folder / "moved.tfm";
  ManualClock Time;
  Study Open{Time, OrdinaryPriority()};
};

TEST_F(StudyTransformTest, FurtherVolumeMovesAndReturns)
{
  const Vector3 here = Vector3::Zero();
  const Vector3 there = Turned() * here;
  EXPECT_EQ(this->ValueAt(here), 700.0);
  this->MoveVolume(this->File);
  this->Settle();
  EXPECT_EQ(this->ValueAt(there), 700.0);
  EXPECT_NE(this->ValueAt(here), 700.0);
  this->Open.Undo();
  this->Settle();
  EXPECT_EQ(this->ValueAt(here), 700.0);
  this->Open.Redo();
  this->MoveVolume({});
  this->Settle();
  EXPECT_TRUE(this->Further().Transform.empty());
  EXPECT_EQ(this->ValueAt(here), 700.0);
}

TEST_F(StudyTransformTest, StructureOfItsValuesIsFeltWhereItIs)
{
  this->MoveVolume(this->File);
  StudyThreshold threshold;
  threshold.Lower = 350.0;
  threshold.VolumeId = 1;
  this->Open.AddThreshold(threshold);
  this->Settle();
  const auto centerOf = [this]
  {
    const int id = this->Open.State().Structures.back().Id;
    const auto contact = this->Open.Pipeline().Newest<TouchContact>(SceneStep::Touch, id);
    return Vector3(contact->Model->BoundsWorld().center());
  };
  const double voxel = std::sqrt(3.0); // a box in turned axes
  EXPECT_LT((centerOf() - Turned().translation()).norm(), voxel);
  this->MoveVolume({}); // takes the structure with it
  this->Settle();
  EXPECT_LT(centerOf().norm(), voxel);
}

TEST_F(StudyTransformTest, BadTransformChangesNothing)
{
  const StudyState before = this->Open.State();
  std::ofstream(this->Phantom.Folder / "bad.lta") << "type = 0\n";
  EXPECT_THROW(this->MoveVolume(this->Phantom.Folder / "bad.lta"), InputError);
  EXPECT_THROW(this->MoveVolume(this->Phantom.Folder / "none.tfm"), InputError);
  EXPECT_EQ(this->Open.State(), before);
}

TEST_F(StudyTransformTest, MatrixOfFlirtIsReadInTheFramesOfBothVolumes)
{
  const std::filesystem::path matrix = this->Phantom.Folder / "moved.mat";
  const std::filesystem::path volume = this->Phantom.Folder / "volume.nii.gz";
  WriteTransform(matrix, Turned(), {volume, volume});
  this->MoveVolume(matrix);
  this->Settle();
  EXPECT_EQ(this->ValueAt(Turned() * Vector3::Zero()), 700.0);
}

TEST_F(StudyTransformTest, TransformThatChangesIsReadAgain)
{
  this->MoveVolume(this->File);
  this->Settle();
  WriteTransform(this->File, Eigen::Affine3d(Eigen::Translation3d(0.0, 0.0, -60.0)));
  this->Open.Change("Rename",
                    [this]
                    {
                      StudyState next = this->Open.State();
                      next.Landmarks.push_back({"A", Vector3::Zero()});
                      return next;
                    }());
  this->Settle();
  EXPECT_EQ(this->ValueAt(Vector3(0.0, 0.0, -60.0)), 700.0);
}

TEST_F(StudyTransformTest, SessionOpensWithIt)
{
  this->MoveVolume(this->File);
  const StudyState saved = this->Open.State();
  this->Open.Save(this->Phantom.Folder / "s.palpate.json");
  this->Open.New();
  this->Open.Open(this->Phantom.Folder / "s.palpate.json");
  EXPECT_EQ(this->Open.State().Volumes, saved.Volumes);
}

TEST_F(StudyTransformTest, NextVolumeShowsOneByOne)
{
  this->Open.AddVolume(this->Phantom.Folder / "mask.nii.gz");
  const auto shown = [this]
  {
    std::vector<int> ids;
    for (const StudyVolume& volume : this->Open.State().Volumes)
    {
      if (volume.IsVisible)
      {
        ids.push_back(volume.Id);
      }
    }
    return ids;
  };
  const auto step = [this] { this->Open.Change("Next", WithNextVolume(this->Open.State())); };
  step();
  EXPECT_EQ(shown(), std::vector<int>{2}); // after the first that was shown
  step();
  EXPECT_EQ(shown(), std::vector<int>{});
  step();
  EXPECT_EQ(shown(), std::vector<int>{1});
}
} // namespace
} // namespace palpate::study_transform_test
