#include "SampleScene.h"

#include "ManualClock.h"
#include "MastoidPhantom.h"
#include "Study.h"
#include "StudyPhantoms.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::sample_scene_test
{
namespace
{
class SampleSceneTest : public testing::Test
{
protected:
  // Opens a scene and makes everything that it needs.
  void Open(SampleScene scene)
  {
    this->One.New(MakeSampleScene(scene, this->Folder.Path()));
    while (this->One.Jobs().WaitForResult())
    {
      this->One.Deliver();
    }
  }
  bool CanTouch(int id) const
  {
    const std::vector<SceneContact> contacts = this->One.Contacts();
    return std::any_of(contacts.begin(), contacts.end(),
                       [id](const SceneContact& one) { return one.Id == id; });
  }

  test::TemporaryFolder Folder;
  ManualClock Time;
  Study One{this->Time};
};

TEST_F(SampleSceneTest, ProstateCanBeTouched)
{
  this->Open(SampleScene::Prostate);
  EXPECT_TRUE(this->CanTouch(1));
  EXPECT_FALSE(this->One.IsChanged());
}

TEST_F(SampleSceneTest, LesionIsAnInclusionOfAnElasticGland)
{
  this->Open(SampleScene::Lesion);
  EXPECT_TRUE(this->CanTouch(1));
  const auto fit = this->One.Pipeline().Newest<FitResult>(SceneStep::Elasticity, 1);
  ASSERT_NE(fit, nullptr);
  EXPECT_EQ(fit->Tissue, "20 kPa, inclusions of 80 kPa");
}

TEST_F(SampleSceneTest, MastoidIsDrilledAroundProtectedStructures)
{
  this->Open(SampleScene::Mastoid);
  const std::vector<SceneContact> contacts = this->One.Contacts();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NE(contacts[0].Drilled.Field, nullptr);
  const auto forbidden = ForbiddenOf(this->One.State(), this->One.Pipeline());
  ASSERT_EQ(forbidden.size(), 2U);
  for (const StudyForbidden& one : forbidden)
  {
    EXPECT_TRUE(one.IsReady()) << one.Name;
  }
}

TEST_F(SampleSceneTest, ImagesAreMadeOnce)
{
  const StudyState first = MakeSampleScene(SampleScene::Mastoid, this->Folder.Path());
  const auto time = std::filesystem::last_write_time(first.VolumeFile);
  bool isMade = false;
  EXPECT_EQ(MakeSampleScene(SampleScene::Mastoid, this->Folder.Path(),
                            [&isMade](double, const std::string&) { return isMade = true; }),
            first);
  EXPECT_FALSE(isMade);
  EXPECT_EQ(std::filesystem::last_write_time(first.VolumeFile), time);
}

TEST_F(SampleSceneTest, CancellingMakesNothing)
{
  EXPECT_THROW(MakeSampleScene(SampleScene::Prostate, this->Folder.Path(),
                               [](double, const std::string&) { return false; }),
               Cancelled);
  EXPECT_TRUE(std::filesystem::is_empty(this->Folder.Path()));
}

TEST_F(SampleSceneTest, NerveLiesDeepInBone)
{
  const MastoidImages made = MakeMastoid();
  const auto* values = static_cast<const short*>(made.Volume->GetScalarPointer());
  const auto* labels = static_cast<const unsigned char*>(made.Labels->GetScalarPointer());
  double deepest = -1e9; // mm, of the nerve to the right
  double surface = 1e9;  // of the bone
  for (vtkIdType voxel = 0; voxel < made.Volume->GetNumberOfPoints(); ++voxel)
  {
    const double x = made.Volume->GetPoint(voxel)[0];
    deepest = labels[voxel] == 1 ? std::max(deepest, -x) : deepest;
    surface = values[voxel] > 300 ? std::min(surface, x) : surface;
  }
  EXPECT_GT(-deepest, surface + 10.0);
}

TEST_F(SampleSceneTest, ComparisonShowsBothSurfaces)
{
  const test::StudyPhantom phantom;
  const auto mask = phantom.Folder / "mask.nii.gz";
  const auto other = phantom.Folder / "other.nii.gz";
  std::filesystem::copy_file(mask, other);
  const StudyState state = CompareMasks(mask, other);
  ASSERT_EQ(state.Structures.size(), 6U);
  EXPECT_EQ(state.SegmentationFile, mask);
  EXPECT_EQ(state.Structures[0].Opacity, 1.0);
  EXPECT_EQ(state.Structures[3].File, other);
  EXPECT_LT(state.Structures[3].Opacity, 1.0);
  EXPECT_NE(state.Structures[0].Color, state.Structures[3].Color);
  for (const SceneStructure& one : state.Structures)
  {
    EXPECT_EQ(one.Appearance, SceneAppearance::Surface);
    EXPECT_TRUE(one.IsVisible);
  }
}
} // namespace
} // namespace palpate::sample_scene_test
