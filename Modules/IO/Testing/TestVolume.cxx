#include "ImageGrid.h"
#include "MessageOf.h"
#include "RandomShapes.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "VolumeFile.h"
#include "WorstCase.h"

#include "vtkPointData.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace palpate::volume_test
{
namespace
{
using namespace palpate::test;

Vector3 WorldOf(vtkImageData* image, int i, int j, int k)
{
  Vector3 world;
  image->TransformIndexToPhysicalPoint(i, j, k, world.data());
  return world;
}

double ValueAt(vtkImageData* image, const Vector3& world)
{
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(world.data(), index);
  return image->GetScalarComponentAsDouble(static_cast<int>(std::lround(index[0])),
                                           static_cast<int>(std::lround(index[1])),
                                           static_cast<int>(std::lround(index[2])), 0);
}

std::string Axis(const Vector3& v)
{
  std::ostringstream text;
  text.precision(17);
  text << '(' << v[0] << ',' << v[1] << ',' << v[2] << ')';
  return text.str();
}

// Raw NRRD, 4 x 5 x 6, with any axes (columns, mm) and an origin.
std::string NrrdWithAxes(const Eigen::Matrix3d& axes, const Vector3& origin,
                         const std::string& voxels)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[4] =
      "space directions: " + Axis(axes.col(0)) + ' ' + Axis(axes.col(1)) + ' ' + Axis(axes.col(2));
  lines[8] = "space origin: " + Axis(origin);
  return NrrdBytes(lines, voxels);
}

template <typename T>
void ExpectNrrdKeepsType(const char* nrrdType, int vtkType)
{
  const TemporaryFolder folder;
  const std::vector<T> values = Counting<T>(120);
  WriteAll(folder / "a.nrrd", NrrdBytes(PlainNrrdLines(nrrdType), BytesOf(values)));
  const Volume volume = ReadVolume(folder / "a.nrrd");
  vtkDataArray* scalars = volume.Image->GetPointData()->GetScalars();
  EXPECT_EQ(scalars->GetDataType(), vtkType) << nrrdType;
  ASSERT_EQ(scalars->GetNumberOfValues(), 120);
  const T* found = static_cast<const T*>(scalars->GetVoidPointer(0));
  EXPECT_TRUE(std::equal(values.begin(), values.end(), found)) << nrrdType;
}

TEST(Volume, NiftiVoxelsFollowSformInLps)
{
  const TemporaryFolder folder;
  NiftiSpec spec;
  // A rotation about two axes; spacings 1.5, 2.5 and 3.5 mm.
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.4, Vector3::UnitZ()) * Eigen::AngleAxisd(-0.3, Vector3::UnitX()))
          .toRotationMatrix();
  const Vector3 spacing(1.5, 2.5, 3.5);
  Eigen::Matrix<double, 3, 4> sform;
  sform << turn * spacing.asDiagonal(), Vector3(-7, 11, 13);
  for (int i = 0; i < 12; ++i)
  {
    spec.SForm[static_cast<std::size_t>(i)] = static_cast<float>(sform(i / 4, i % 4));
  }
  spec.PixelDimensions = {1, 1.5F, 2.5F, 3.5F};
  WriteAll(folder / "a.nii", NiftiBytes(spec, BytesOf(Counting<unsigned char>(120))));
  const Volume volume = ReadVolume(folder / "a.nii");
  WorstCase worst;
  for (int k : {0, 5})
  {
    for (int j : {0, 4})
    {
      for (int i : {0, 3})
      {
        const Vector3 ras = sform * Eigen::Vector4d(i, j, k, 1);
        const Vector3 lps(-ras[0], -ras[1], ras[2]);
        worst.Add((WorldOf(volume.Image, i, j, k) - lps).norm());
        EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(i, j, k, 0), i + 4 * j + 20 * k);
      }
    }
  }
  // The header has single precision: 6e-8 of 30 mm, through a quaternion and back.
  EXPECT_LT(worst.Value(), 2e-5);
}

TEST(Volume, KeepsScalarTypeOfFile)
{
  ExpectNrrdKeepsType<unsigned char>("unsigned char", VTK_UNSIGNED_CHAR);
  ExpectNrrdKeepsType<signed char>("signed char", VTK_SIGNED_CHAR);
  ExpectNrrdKeepsType<unsigned short>("unsigned short", VTK_UNSIGNED_SHORT);
  ExpectNrrdKeepsType<short>("short", VTK_SHORT);
  ExpectNrrdKeepsType<unsigned int>("unsigned int", VTK_UNSIGNED_INT);
  ExpectNrrdKeepsType<int>("int", VTK_INT);
  ExpectNrrdKeepsType<float>("float", VTK_FLOAT);
  ExpectNrrdKeepsType<double>("double", VTK_DOUBLE);
}

TEST(Volume, AppliesNiftiSlopeAndIntercept)
{
  const TemporaryFolder folder;
  NiftiSpec spec;
  spec.Slope = 0.5F;
  spec.Intercept = -3.0F;
  WriteAll(folder / "a.nii", NiftiBytes(spec, BytesOf(Counting<unsigned char>(120))));
  const Volume volume = ReadVolume(folder / "a.nii");
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(3, 4, 5, 0), 119 * 0.5 - 3.0);
}

TEST(Volume, CompressedAndPlainNiftiAreEqual)
{
  const TemporaryFolder folder;
  const std::string bytes = NiftiBytes({}, BytesOf(Counting<unsigned char>(120)));
  WriteAll(folder / "a.nii", bytes);
  WriteAll(folder / "a.nii.gz", Gzipped(bytes));
  const Volume plain = ReadVolume(folder / "a.nii");
  const Volume packed = ReadVolume(folder / "a.nii.gz");
  for (vtkIdType i = 0; i < 120; ++i)
  {
    EXPECT_EQ(plain.Image->GetPointData()->GetScalars()->GetTuple1(i),
              packed.Image->GetPointData()->GetScalars()->GetTuple1(i));
  }
}

TEST(Volume, CompressedNiftiNextToPlainOneKeepsOwnVoxels)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nii", NiftiBytes({}));
  WriteAll(folder / "a.nii.gz", Gzipped(NiftiBytes({}, BytesOf(Counting<unsigned char>(120)))));
  EXPECT_EQ(ReadVolume(folder / "a.nii").Image->GetScalarComponentAsDouble(3, 4, 5, 0), 0.0);
  EXPECT_EQ(ReadVolume(folder / "a.nii.gz").Image->GetScalarComponentAsDouble(3, 4, 5, 0), 119.0);
}

TEST(Volume, NiftiByteOrdersAreEquivalent)
{
  const TemporaryFolder folder;
  NiftiSpec spec;
  spec.Type = 4;
  spec.Bits = 16;
  std::string bytes = NiftiBytes(spec, BytesOf(Counting<short>(120)));
  const auto reverse = [&bytes](std::size_t first, std::size_t size, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto start = bytes.begin() + static_cast<std::ptrdiff_t>(first + i * size);
      std::reverse(start, start + static_cast<std::ptrdiff_t>(size));
    }
  };
  reverse(0, 4, 1);
  reverse(40, 2, 8);
  reverse(70, 2, 2);
  reverse(76, 4, 11); // pixdim, vox_offset, slope, intercept
  reverse(252, 2, 2);
  reverse(256, 4, 18);
  reverse(352, 2, 120);
  WriteAll(folder / "a.nii", bytes);
  const Volume volume = ReadVolume(folder / "a.nii");
  EXPECT_EQ(volume.Image->GetScalarType(), VTK_SHORT);
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(3, 4, 5, 0), 119.0);
  EXPECT_EQ(WorldOf(volume.Image, 3, 4, 5), Vector3(-16, -28, 40));
}

TEST(Volume, ReadsNiftiSformFarFromOriginOrWithFineVoxels)
{
  for (const float spacing : {0.01F, 0.02F, 1.0F})
  {
    for (const float offset : {0.0F, 3e4F, -1e5F})
    {
      const TemporaryFolder folder;
      NiftiSpec spec;
      spec.PixelDimensions = {1, spacing, spacing, 3 * spacing};
      spec.SForm = {spacing, 0, 0, offset, 0, spacing, 0, -offset, 0, 0, 3 * spacing, offset};
      WriteAll(folder / "a.nii", NiftiBytes(spec));
      const Volume volume = ReadVolume(folder / "a.nii");
      const Vector3 last(3 * spacing + offset, 4 * spacing - offset, 15 * spacing + offset);
      const Vector3 expected(-last[0], -last[1], last[2]);
      // Single precision of 1e5 mm.
      EXPECT_LT((WorldOf(volume.Image, 3, 4, 5) - expected).norm(), 0.02);
      // 0.3 mm in all, which is noted.
      EXPECT_EQ(volume.Notes.size(), spacing < 1.0F ? 1u : 0u);
    }
  }
}

TEST(Volume, NotesNiftiWithoutOrientation)
{
  const TemporaryFolder folder;
  NiftiSpec spec;
  spec.SFormCode = 0;
  WriteAll(folder / "a.nii", NiftiBytes(spec));
  EXPECT_EQ(ReadVolume(folder / "a.nii").Notes.size(), 1u);
  spec.SFormCode = 1;
  WriteAll(folder / "b.nii", NiftiBytes(spec));
  EXPECT_TRUE(ReadVolume(folder / "b.nii").Notes.empty());
}

TEST(Volume, ConsistentNiftiFormsGetNoNote)
{
  const TemporaryFolder folder;
  NiftiSpec spec;
  spec.QFormCode = 1;
  WriteAll(folder / "a.nii", NiftiBytes(spec));
  EXPECT_TRUE(ReadVolume(folder / "a.nii").Notes.empty());
  // Half a turn about z: quaternion 0, 0, 0, 1.
  spec.QForm = {0, 0, 1, 10, 20, 30};
  spec.SForm = {-2, 0, 0, 10, 0, -2, 0, 20, 0, 0, 2, 30};
  WriteAll(folder / "b.nii", NiftiBytes(spec));
  EXPECT_TRUE(ReadVolume(folder / "b.nii").Notes.empty());
}

TEST(Volume, NotesInconsistentNiftiForms)
{
  const TemporaryFolder folder;
  NiftiSpec spec;
  spec.QFormCode = 1;
  spec.QForm[3] = 17;
  WriteAll(folder / "a.nii", NiftiBytes(spec));
  const std::vector<std::string> notes = ReadVolume(folder / "a.nii").Notes;
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(Contains(notes[0],
                       "would place voxels up to 7 mm elsewhere; the other orientation was used"));
}

TEST(Volume, AcceptsFourthDimensionOfOne)
{
  const TemporaryFolder folder;
  NiftiSpec spec;
  spec.Dimensions = {4, 4, 5, 6, 1, 1, 1, 1};
  WriteAll(folder / "a.nii", NiftiBytes(spec));
  EXPECT_EQ(ReadVolume(folder / "a.nii").Image->GetDimensions()[2], 6);
}

TEST(Volume, MetaImageVoxelsFollowMatrix)
{
  const TemporaryFolder folder;
  // Rows of TransformMatrix are the index axes: x runs to -S, y to L, z to -P.
  WriteAll(folder / "a.mha",
           MetaImageBytes("MET_UCHAR", BytesOf(Counting<unsigned char>(120)),
                          "TransformMatrix = 0 0 -1 1 0 0 0 -1 0\nElementSpacing = 1 2 3\n"));
  const Volume volume = ReadVolume(folder / "a.mha");
  EXPECT_LT((WorldOf(volume.Image, 3, 0, 0) - Vector3(10, 20, 27)).norm(), 1e-12);
  EXPECT_LT((WorldOf(volume.Image, 0, 4, 0) - Vector3(18, 20, 30)).norm(), 1e-12);
  EXPECT_LT((WorldOf(volume.Image, 0, 0, 5) - Vector3(10, 5, 30)).norm(), 1e-12);
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(3, 4, 5, 0), 119);
}

TEST(Volume, VoxelsKeepPositionForEitherHandedness)
{
  const TemporaryFolder folder;
  Random random(20261);
  const std::vector<unsigned char> values = Counting<unsigned char>(120);
  for (int round = 0; round < 40; ++round)
  {
    Eigen::Matrix3d axes = Eigen::AngleAxisd(round, RandomDirection(random)).toRotationMatrix();
    const bool leftHanded = round % 2 == 1;
    axes.col(round % 3) *= leftHanded ? -1.0 : 1.0;
    const Vector3 spacing(0.5, 1.25, 3.0);
    const Vector3 origin = 100.0 * RandomDirection(random);
    WriteAll(folder / "a.nrrd", NrrdWithAxes(axes * spacing.asDiagonal(), origin, BytesOf(values)));
    const Volume volume = ReadVolume(folder / "a.nrrd");
    EXPECT_GT(GridOf(volume.Image).Direction.determinant(), 0.999);
    EXPECT_EQ(volume.Notes.size(), leftHanded ? 1u : 0u);
    for (int voxel = 0; voxel < 120; ++voxel)
    {
      const int row = voxel / 4 % 5;
      const int slice = voxel / 20;
      const Vector3 index(voxel % 4, row, slice);
      const Vector3 world = origin + axes * spacing.asDiagonal() * index;
      ASSERT_EQ(ValueAt(volume.Image, world), voxel) << "round " << round;
    }
  }
}

TEST(Volume, LeftHandedFileIsReversedTowardsLps)
{
  const TemporaryFolder folder;
  const Eigen::Matrix3d axes = Vector3(2, -2, 2).asDiagonal();
  WriteAll(folder / "a.nrrd", NrrdWithAxes(axes, {0, 0, 0}, std::string(120, '\0')));
  const Volume volume = ReadVolume(folder / "a.nrrd");
  EXPECT_TRUE(GridOf(volume.Image).Direction.isIdentity(1e-15));
  EXPECT_EQ(GridOf(volume.Image).OriginWorld, Vector3(0, -8, 0));
}

TEST(Volume, PromiseCaseHasNominalGeometry)
{
  const auto path = DataPath("prostate/promise12_0_t2.nii.gz");
  PALPATE_REQUIRE_FILE(path);
  const ImageGrid grid = GridOf(ReadVolume(path).Image);
  EXPECT_EQ(grid.Size, (std::array<int, 3>{128, 128, 32}));
  // Single precision in the header.
  EXPECT_LT((grid.Spacing - Vector3(1.4, 1.4, 1.6)).norm(), 1e-6);
}
} // namespace
} // namespace palpate::volume_test
