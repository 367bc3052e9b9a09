#include "StudyFile.h"

#include "ImageFormat.h"
#include "InputError.h"
#include "ModelFile.h"
#include "StudyPhantoms.h"
#include "SurfaceFile.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::study_file_role_test
{
namespace
{
TEST(StudyFileRole, FollowsFromNameOrContent)
{
  const test::StudyPhantom phantom;
  EXPECT_EQ(RoleOf(phantom.Folder / "mask.nii.gz"), StudyFileRole::Segmentation);
  const auto grey = phantom.Folder / "grey.nrrd";
  const auto image =
      test::MakeLabelImage<float>(test::LabelGrid(), [](double, double, double) { return true; });
  for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
  {
    static_cast<float*>(image->GetScalarPointer())[v] =
        std::sin(0.37F * static_cast<float>(v % 1009));
  }
  WriteImage(grey, image);
  EXPECT_EQ(RoleOf(grey), StudyFileRole::Volume);
  // It need not exist: opening it reports that.
  EXPECT_EQ(RoleOf("case.palpate.json"), StudyFileRole::Session);
}

// Every ending of the lists that fit and convert read by, without opening the file.
TEST(StudyFileRole, FollowsFromTheListsOfFormats)
{
  for (const std::string& ending : SurfaceFormats().ReadEndings())
  {
    EXPECT_EQ(RoleByName("absent" + ending), StudyFileRole::Surface) << ending;
  }
  for (const std::string& ending : ReadableModelEndings())
  {
    EXPECT_EQ(RoleByName("absent" + ending), StudyFileRole::Model) << ending;
  }
  for (const std::string& ending : ReadableImageEndings())
  {
    EXPECT_FALSE(RoleByName("absent" + ending)) << ending;
  }
  EXPECT_EQ(RoleByName("a.scene.json"), StudyFileRole::Scene);
  EXPECT_EQ(RoleByName("a.palpate.json"), StudyFileRole::Session);
  EXPECT_EQ(RoleByName("a.mrk.json"), StudyFileRole::Markups);
}

TEST(StudyFileRole, RejectsUnknownFiles)
{
  const test::TemporaryFolder folder;
  test::WriteAll(folder / "bad.nii.gz", "no image");
  EXPECT_THROW((void)RoleOf(folder / "bad.nii.gz"), InputError);
  EXPECT_THROW((void)RoleOf(folder / "absent.nrrd"), InputError);
}
} // namespace
} // namespace palpate::study_file_role_test
