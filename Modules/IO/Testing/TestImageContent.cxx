#include "ImageContent.h"
#include "LabelMap.h"
#include "MessageOf.h"
#include "RandomShapes.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "VolumeFile.h"

#include <gtest/gtest.h>

namespace palpate::image_content_test
{
namespace
{
using namespace palpate::test;

const std::filesystem::path Templates = "/usr/share/mricron/templates";

template <typename T>
ImageContent ContentOf(const char* type, const std::vector<T>& values)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nrrd", NrrdBytes(PlainNrrdLines(type), BytesOf(values)));
  return ReadImageContent(folder / "a.nrrd");
}

TEST(ImageContent, FewWholeValuesAreLabels)
{
  std::vector<double> values(120, 0.0);
  values[7] = 3.0;
  const ImageContent content = ContentOf("double", values);
  ASSERT_TRUE(content.Labels);
  EXPECT_EQ(content.Kind, "NRRD label map");
  EXPECT_EQ(content.Labels->Segments[0].Label, 3);
}

TEST(ImageContent, NoiseIsVolume)
{
  Random random(5);
  std::vector<unsigned char> values(120);
  for (unsigned char& value : values)
  {
    value = static_cast<unsigned char>(random() % 200);
  }
  const ImageContent content = ContentOf("unsigned char", values);
  EXPECT_FALSE(content.Labels);
  EXPECT_TRUE(Contains(content.KindReason, "vary from voxel to voxel"));
}

TEST(ImageContent, NegativeOrFractionalValuesAreVolume)
{
  EXPECT_FALSE(ContentOf("short", std::vector<short>(120, -1)).Labels);
  EXPECT_FALSE(ContentOf("float", std::vector<float>(120, 0.5F)).Labels);
}

TEST(ImageContent, ZerosAreVolume)
{
  const ImageContent content = ContentOf("short", std::vector<short>(120, 0));
  EXPECT_FALSE(content.Labels);
  EXPECT_EQ(content.KindReason, "all its voxels are 0");
}

TEST(ImageContent, RecognizesAtlasesAndHeads)
{
  PALPATE_REQUIRE_FILE(Templates / "aal.nii.gz");
  for (const char* name : {"aal", "brodmann", "AICHAmc", "jhu189", "natbrainlab",
                           "inia19-NeuroMaps", "JHU-WhiteMatter-labels-2mm"})
  {
    const Volume volume = ReadVolume(Templates / (std::string(name) + ".nii.gz"));
    EXPECT_EQ(WhyNoLabelMap(volume), "") << name;
  }
  for (const char* name : {"ch2", "ch2bet", "ch2better", "inia19-t1-brain"})
  {
    const Volume volume = ReadVolume(Templates / (std::string(name) + ".nii.gz"));
    EXPECT_NE(WhyNoLabelMap(volume), "") << name;
  }
}
} // namespace
} // namespace palpate::image_content_test
