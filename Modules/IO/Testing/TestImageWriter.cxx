#include "FileSizeLimit.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "TemporaryFolder.h"
#include "Vector3.h"
#include "VolumeFile.h"
#include "vtkDataArray.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <random>

namespace palpate::image_writer_test
{
namespace
{
using namespace palpate::test;

const char* const Names[] = {"a.nii", "a.nii.gz", "a.nrrd", "a.mha"};

// Noise on an oblique, anisotropic grid.
vtkSmartPointer<vtkImageData> Oblique(int scalarType)
{
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> direction =
      Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(17, 11, 5);
  image->SetSpacing(0.3125, 0.5, 3.6);
  image->SetOrigin(-81.25, 17.5, 240.125);
  image->SetDirectionMatrix(direction.data());
  image->AllocateScalars(scalarType, 1);
  std::mt19937_64 random(5);
  vtkDataArray* voxels = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < voxels->GetNumberOfTuples(); ++i)
  {
    voxels->SetTuple1(i, static_cast<double>(random() % 120));
  }
  return image;
}

double LargestCornerShift(vtkImageData* a, vtkImageData* b)
{
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const int i = corner & 1 ? 16 : 0;
    const int j = corner & 2 ? 10 : 0;
    const int k = corner & 4 ? 4 : 0;
    Vector3 first;
    Vector3 second;
    a->TransformIndexToPhysicalPoint(i, j, k, first.data());
    b->TransformIndexToPhysicalPoint(i, j, k, second.data());
    const double shift = (first - second).norm();
    largest = shift <= largest ? largest : shift; // NaN counts as large
  }
  return largest;
}

TEST(ImageWriter, EveryFormatKeepsTypeAndValues)
{
  for (const char* name : Names)
  {
    const TemporaryFolder folder;
    for (const int type : {VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_SHORT,
                           VTK_UNSIGNED_INT, VTK_INT, VTK_FLOAT, VTK_DOUBLE})
    {
      const auto image = Oblique(type);
      WriteImage(folder / name, image);
      const auto back = ReadVolume(folder / name).Image;
      ASSERT_EQ(back->GetScalarType(), type) << name;
      vtkDataArray* before = image->GetPointData()->GetScalars();
      vtkDataArray* after = back->GetPointData()->GetScalars();
      ASSERT_EQ(after->GetNumberOfTuples(), before->GetNumberOfTuples()) << name;
      for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
      {
        ASSERT_EQ(after->GetTuple1(i), before->GetTuple1(i)) << name << ", type " << type;
      }
    }
  }
}

TEST(ImageWriter, WritesLongIntegersThatFitAsInt)
{
  for (const char* name : Names)
  {
    const TemporaryFolder folder;
    const auto image = Oblique(VTK_LONG_LONG);
    image->GetPointData()->GetScalars()->SetTuple1(0, -70000);
    WriteImage(folder / name, image);
    const auto back = ReadVolume(folder / name).Image;
    EXPECT_EQ(back->GetScalarType(), VTK_INT) << name;
    vtkDataArray* before = image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
    {
      ASSERT_EQ(back->GetPointData()->GetScalars()->GetTuple1(i), before->GetTuple1(i)) << name;
    }
  }
}

TEST(ImageWriter, EveryFormatKeepsCornerPositions)
{
  for (const char* name : Names)
  {
    const TemporaryFolder folder;
    const auto image = Oblique(VTK_SHORT);
    WriteImage(folder / name, image);
    // NIfTI keeps its geometry in single precision: some 1e-5 mm at 260 mm.
    EXPECT_LT(LargestCornerShift(image, ReadVolume(folder / name).Image), 1e-4) << name;
  }
}

TEST(ImageWriter, NrrdAndMetaImageKeepGridInDouble)
{
  const TemporaryFolder folder;
  for (const char* name : {"a.nrrd", "a.mha"})
  {
    const auto image = Oblique(VTK_SHORT);
    WriteImage(folder / name, image);
    // Both write 17 digits; spacing and direction are multiplied and separated again.
    EXPECT_LT(LargestCornerShift(image, ReadVolume(folder / name).Image), 1e-11) << name;
  }
}

TEST(ImageWriter, KeepsPositionOfExtentNotStartingAtZero)
{
  const TemporaryFolder folder;
  const auto image = Oblique(VTK_SHORT);
  const auto shifted = vtkSmartPointer<vtkImageData>::New();
  shifted->ShallowCopy(image);
  shifted->SetExtent(3, 19, -2, 8, 1, 5);
  WriteImage(folder / "a.nrrd", shifted);
  Vector3 expected;
  shifted->TransformIndexToPhysicalPoint(3, -2, 1, expected.data());
  const Vector3 found(ReadVolume(folder / "a.nrrd").Image->GetOrigin());
  EXPECT_LT((found - expected).norm(), 1e-11); // 17 digits of numbers near 250
}

TEST(ImageWriter, WritesSingleSlices)
{
  const TemporaryFolder folder;
  vtkNew<vtkImageData> slice;
  slice->SetDimensions(7, 4, 1);
  slice->AllocateScalars(VTK_SHORT, 1);
  slice->GetPointData()->GetScalars()->Fill(3.0);
  for (const char* name : Names)
  {
    EXPECT_NO_THROW(WriteImage(folder / name, slice)) << name;
  }
}

TEST(ImageWriter, UnwritableImageLeavesNothing)
{
  const TemporaryFolder folder;
  vtkNew<vtkImageData> empty;
  vtkNew<vtkImageData> colour;
  colour->SetDimensions(2, 2, 2);
  colour->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (const char* name : Names)
  {
    EXPECT_THROW(WriteImage(folder / name, empty), InputError) << name;
    EXPECT_THROW(WriteImage(folder / name, colour), InputError) << name;
    const auto wide = Oblique(VTK_LONG);
    wide->GetPointData()->GetScalars()->SetTuple1(3, 5e9);
    EXPECT_THROW(WriteImage(folder / name, wide), InputError) << name;
  }
  EXPECT_THROW(WriteImage(folder / "a.mhd", Oblique(VTK_SHORT)), InputError);
  EXPECT_THROW(WriteImage(folder / "a.txt", Oblique(VTK_SHORT)), InputError);
  EXPECT_EQ(folder.EntryCount(), 0u);
}

TEST(ImageWriter, FullDiskKeepsOldFile)
{
  const TemporaryFolder folder;
  for (const char* name : Names)
  {
    WriteAll(folder / name, "old");
    {
      const FileSizeLimit limit(600);
      EXPECT_THROW(WriteImage(folder / name, Oblique(VTK_DOUBLE)), InputError) << name;
    }
    EXPECT_EQ(ReadAll(folder / name), "old") << name;
  }
  EXPECT_EQ(folder.EntryCount(), 4u);
}
} // namespace
} // namespace palpate::image_writer_test
