#include "ChosenValues.h"

#include "ImageContent.h"
#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::chosen_values_test
{
namespace
{
using namespace palpate::test;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

VolumeChoice Choice(const ValueChoice& values)
{
  VolumeChoice choice;
  choice.Values = values;
  return choice;
}

template <typename T>
Segmentation Labels(const char* type, const std::vector<T>& values, const ValueChoice& choice)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nrrd", NrrdBytes(PlainNrrdLines(type), BytesOf(values)));
  return ReadSegmentation(folder / "a.nrrd", Choice(choice));
}

template <typename T>
std::string Refusal(const char* type, const std::vector<T>& values, const ValueChoice& choice = {})
{
  return MessageOf([&] { Labels(type, values, choice); });
}

double At(const Segmentation& labels, vtkIdType voxel)
{
  return labels.Layers[0]->GetPointData()->GetScalars()->GetTuple1(voxel);
}

TEST(ChosenValues, ThresholdMakesMaskOfProbabilities)
{
  std::vector<float> values(120, 0.2F);
  values[5] = 0.5F;
  values[6] = 0.9F;
  values[7] = std::numeric_limits<float>::quiet_NaN();
  values[8] = -1.0F;
  const Segmentation labels = Labels("float", values, {0.5, {}});
  for (vtkIdType voxel = 0; voxel < 120; ++voxel)
  {
    EXPECT_EQ(At(labels, voxel), voxel == 5 || voxel == 6 ? 1.0 : 0.0) << voxel;
  }
  ASSERT_EQ(labels.Notes.size(), 1u);
  EXPECT_TRUE(Contains(labels.Notes[0], "2 voxels of at least 0.5"));
}

TEST(ChosenValues, BackgroundTakesNaNAndNegativeValues)
{
  std::vector<float> values(120, -1.0F);
  values[5] = 2.0F;
  values[6] = std::numeric_limits<float>::quiet_NaN();
  values[7] = std::numeric_limits<float>::infinity();
  const Segmentation labels = Labels("float", values, {{}, {-1.0, NaN}});
  EXPECT_EQ(At(labels, 5), 2.0);
  EXPECT_EQ(At(labels, 0) + At(labels, 6) + At(labels, 7), 0.0);
}

// -1 is not 255 of an unsigned type, and -0.1 is that of single precision.
TEST(ChosenValues, BackgroundIsComparedInTypeOfImage)
{
  std::vector<unsigned char> bytes(120, 255);
  EXPECT_EQ(At(Labels("unsigned char", bytes, {{}, {-1.0}}), 0), 255.0);
  std::vector<float> floats(120, -0.1F);
  floats[3] = 1.0F;
  EXPECT_EQ(At(Labels("float", floats, {{}, {-0.1}}), 3), 1.0);
}

TEST(ChosenValues, RefusalsNameTheOption)
{
  EXPECT_TRUE(Contains(Refusal("float", std::vector<float>(120, 0.3F)), "--threshold"));
  EXPECT_TRUE(Contains(Refusal("short", std::vector<short>(120, -1)), "--background -1"));
  std::vector<float> values(120, 1.0F);
  values[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(Contains(Refusal("float", values), "--background nan"));
}

TEST(ChosenValues, RejectsThresholdThatNoVoxelReaches)
{
  EXPECT_TRUE(Contains(Refusal("float", std::vector<float>(120, 0.25F), {0.5, {}}),
                       "largest value is 0.25"));
}

// A scale factor of 0.1 in single precision, and interpolation, leave such values.
TEST(ChosenValues, LabelsAreRoundedWithinThousandthWithNote)
{
  std::vector<double> values(120, 1e-8);
  values[5] = 2.9999;
  values[6] = -1e-8;
  values[7] = 1.0009;
  const Segmentation labels = Labels("double", values, {});
  EXPECT_EQ(At(labels, 5), 3.0);
  EXPECT_EQ(At(labels, 7), 1.0);
  EXPECT_EQ(At(labels, 0) + At(labels, 6), 0.0);
  ASSERT_EQ(labels.Notes.size(), 1u);
  EXPECT_TRUE(Contains(labels.Notes[0], "rounded, by up to 0.0009"));
  values[7] = 1.002;
  EXPECT_TRUE(Contains(Refusal("double", values), "the value 1.002"));
}

TEST(ChosenValues, RoundedLabelsAreTakenForLabelMap)
{
  const TemporaryFolder folder;
  std::vector<float> values(120, 0.0F);
  values[5] = 2.9999F;
  WriteAll(folder / "a.nrrd", NrrdBytes(PlainNrrdLines("float"), BytesOf(values)));
  EXPECT_TRUE(ReadImageContent(folder / "a.nrrd").Labels);
  // A map of small numbers is no empty mask.
  WriteAll(folder / "b.nrrd",
           NrrdBytes(PlainNrrdLines("float"), BytesOf(std::vector<float>(120, 1e-4F))));
  EXPECT_TRUE(Contains(ReadImageContent(folder / "b.nrrd").KindReason, "not whole numbers"));
}
} // namespace
} // namespace palpate::chosen_values_test
