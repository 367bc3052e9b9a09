#include "MessageOf.h"
#include "SegmentationFile.h"
#include "StoredImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::mgh_format_test
{
namespace
{
using namespace palpate::test;

std::string Plain(const MghSpec& spec = {})
{
  return MghBytes(spec, BytesOf(Counting<unsigned char>(120)));
}

Vector3 WorldOf(vtkImageData* image, int i, int j, int k)
{
  Vector3 world;
  image->TransformIndexToPhysicalPoint(i, j, k, world.data());
  return world;
}

template <typename T>
void ExpectKeepsType(std::int32_t code, int vtkType)
{
  MghSpec spec;
  spec.Type = code;
  const std::vector<T> values = Counting<T>(120);
  const Volume volume = ReadBytes("a.mgh", MghBytes(spec, BigEndian(values)));
  ASSERT_EQ(volume.Image->GetScalarType(), vtkType);
  const T* found = static_cast<const T*>(volume.Image->GetScalarPointer());
  EXPECT_TRUE(std::equal(values.begin(), values.end(), found));
}

TEST(MghFormat, KeepsVoxelsOfEveryType)
{
  ExpectKeepsType<unsigned char>(0, VTK_UNSIGNED_CHAR);
  ExpectKeepsType<int>(1, VTK_INT);
  ExpectKeepsType<float>(3, VTK_FLOAT);
  ExpectKeepsType<short>(4, VTK_SHORT);
}

// The position of voxel (i, j, k) is c_ras + axes * spacing * (index - size / 2) in RAS.
TEST(MghFormat, VoxelsAreAroundStatedCentre)
{
  MghSpec spec;
  spec.Spacing = {1, 2, 3};
  spec.Axes = {0, 1, 0, 0, 0, 1, 1, 0, 0}; // x anterior, y superior, z right
  spec.Center = {7, 11, 13};
  const Volume volume = ReadBytes("a.mgh", Plain(spec));
  EXPECT_TRUE(volume.Notes.empty());
  const Vector3 ras(7 + 3 * (5 - 3), 11 + 1 * (3 - 2), 13 + 2 * (4 - 2.5));
  EXPECT_EQ(WorldOf(volume.Image, 3, 4, 5), Vector3(-ras[0], -ras[1], ras[2]));
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(3, 4, 5, 0), 119.0);
}

TEST(MghFormat, CompressedAndPlainAreEqual)
{
  for (const char* name : {"a.mgz", "a.mgh.gz", "a.MGZ"})
  {
    const Volume volume = ReadBytes(name, Gzipped(Plain()));
    EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(3, 4, 5, 0), 119.0) << name;
  }
}

TEST(MghFormat, NotesMissingOrientation)
{
  MghSpec spec;
  spec.HasOrientation = 0;
  spec.Axes = {9, 9, 9, 9, 9, 9, 9, 9, 9};
  spec.Spacing = {0, 0, 0};
  const Volume volume = ReadBytes("a.mgh", Plain(spec));
  ASSERT_EQ(volume.Notes.size(), 2u);
  EXPECT_TRUE(Contains(volume.Notes[0], "FreeSurfer's default was taken"));
  // The default is left-handed (left, inferior, anterior), so the last axis was reversed.
  EXPECT_TRUE(Contains(volume.Notes[1], "index axis 3 was reversed"));
  EXPECT_EQ(WorldOf(volume.Image, 0, 0, 5), Vector3(-2, 3, 2.5));
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(0, 0, 5, 0), 0.0);
}

TEST(MghFormat, ReadsLabels)
{
  const TemporaryFolder folder;
  MghSpec spec;
  spec.Type = 1;
  std::vector<int> labels(120, 0);
  labels[50] = 14175; // FreeSurfer's largest number of a structure
  WriteAll(folder / "aseg.mgz", Gzipped(MghBytes(spec, BigEndian(labels))));
  const Segmentation segmentation = ReadSegmentation(folder / "aseg.mgz");
  ASSERT_EQ(segmentation.Segments.size(), 1u);
  EXPECT_EQ(segmentation.Segments[0].Label, 14175);
}

TEST(MghFormat, IgnoresTagsBehindVoxels)
{
  const std::string tags = "\0\0\0\3 Jane Doe" + std::string(1000, 'x');
  EXPECT_EQ(ReadBytes("a.mgh", Plain() + tags).Notes.size(), 0u);
  EXPECT_EQ(ReadBytes("a.mgz", Gzipped(Plain() + tags)).Notes.size(), 0u);
}

TEST(MghFormat, VolumeIsChosenByNumber)
{
  MghSpec spec;
  spec.Sizes[3] = 3;
  std::string voxels;
  for (const char value : {'\1', '\2', '\3'})
  {
    voxels += std::string(120, value);
  }
  const std::string bytes = MghBytes(spec, voxels);
  EXPECT_TRUE(Contains(RefusalOf("a.mgh", bytes), "holds 3 volumes; choose one by its number"));
  for (int number = 1; number <= 3; ++number)
  {
    const Volume volume = ReadBytes("a.mgz", Gzipped(bytes), {std::to_string(number)});
    EXPECT_EQ(volume.Image->GetPointData()->GetScalars()->GetRange()[0], number);
    EXPECT_EQ(volume.Image->GetPointData()->GetScalars()->GetRange()[1], number);
  }
}

TEST(MghFormat, RejectsFilesTruncatedAnywhere)
{
  ExpectTruncationsAreRefused("a.mgh", Plain());
  ExpectTruncationsAreRefused("a.mgz", Gzipped(Plain()));
}

TEST(MghFormat, RejectsAbsurdSizes)
{
  constexpr std::int32_t Most = std::numeric_limits<std::int32_t>::max();
  MghSpec spec;
  spec.Sizes = {Most, Most, Most, 1};
  EXPECT_TRUE(Contains(RefusalOf("a.mgh", Plain(spec)), "has a damaged header"));
  spec.Sizes = {30000, 30000, 30000, 1};
  EXPECT_TRUE(Contains(RefusalOf("a.mgh", Plain(spec)), "is truncated"));
  EXPECT_TRUE(Contains(RefusalOf("a.mgz", Gzipped(Plain(spec))), "cannot hold them"));
  spec.Sizes = {4, 5, 6, Most};
  EXPECT_TRUE(Contains(RefusalOf("a.mgh", Plain(spec)), "is truncated"));
  spec.Sizes = {4, -5, 6, 1};
  EXPECT_TRUE(Contains(RefusalOf("a.mgh", Plain(spec)), "a size of -5"));
  spec.Sizes = {4, 5, 6, 0};
  EXPECT_TRUE(Contains(RefusalOf("a.mgh", Plain(spec)), "a size of 0"));
  spec.Sizes = {4, 30, 1, 1};
  EXPECT_TRUE(Contains(RefusalOf("a.mgh", Plain(spec)), "is two-dimensional"));
}

TEST(MghFormat, RejectsWrongMarkTypeAndGeometry)
{
  const auto refusal = [](auto change)
  {
    MghSpec spec;
    change(spec);
    return RefusalOf("a.mgh", Plain(spec));
  };
  constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(Contains(refusal([](MghSpec& s) { s.Version = 2; }), "is not a FreeSurfer volume"));
  EXPECT_TRUE(Contains(refusal([](MghSpec& s) { s.Type = 6; }), "not supported (code 6)"));
  EXPECT_TRUE(Contains(refusal([](MghSpec& s) { s.Spacing[1] = 0; }), "voxel spacing of 0"));
  EXPECT_TRUE(Contains(refusal([](MghSpec& s) { s.Spacing[1] = NaN; }), "voxel spacing of"));
  EXPECT_TRUE(Contains(refusal([](MghSpec& s) { s.Center[1] = NaN; }), "is not finite"));
  EXPECT_TRUE(Contains(refusal([](MghSpec& s) { s.Axes[0] = NaN; }), "is not finite"));
  EXPECT_TRUE(Contains(refusal([](MghSpec& s) { s.Axes[1] = 0.5F; }), "not perpendicular"));
}

TEST(MghFormat, RejectsVoxelsThatAreNotFinite)
{
  MghSpec spec;
  spec.Type = 3;
  std::vector<float> values(120, 1.0F);
  values[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(Contains(RefusalOf("a.mgh", MghBytes(spec, BigEndian(values))),
                       "1 voxels that are NaN or infinite"));
}
} // namespace
} // namespace palpate::mgh_format_test
