#include "OrthogonalResampling.h"

#include "ImageContent.h"
#include "ImageGrid.h"
#include "SegmentationFile.h"
#include "TestData.h"
#include "VolumeFile.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace palpate::orthogonal_resampling_test
{
namespace
{
using namespace palpate::test;

// Slices of 40 x 40 voxels, each pushed along its rows and columns against the one below.
ImageGrid TiltedGrid()
{
  ImageGrid grid;
  grid.Size = {40, 40, 20};
  grid.Spacing = {1.0, 0.8, 2.0};
  grid.OriginWorld = {-20, 5, 7};
  grid.Direction.col(2) = Vector3(0.1, -0.35, 1.0).normalized();
  return grid;
}

Vector3 WorldOf(const ImageGrid& grid, const Vector3& index)
{
  return grid.OriginWorld + grid.Direction * index.cwiseProduct(grid.Spacing);
}

template <typename Array>
vtkSmartPointer<vtkImageData> Sampled(const ImageGrid& grid,
                                      const std::function<double(const Vector3&)>& value)
{
  vtkNew<Array> voxels;
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    for (int j = 0; j < grid.Size[1]; ++j)
    {
      for (int i = 0; i < grid.Size[0]; ++i)
      {
        voxels->InsertNextTuple1(value(WorldOf(grid, Vector3(i, j, k))));
      }
    }
  }
  return MakeImage(grid, voxels);
}

double VoxelVolume(vtkImageData* image)
{
  const ImageGrid grid = GridOf(image);
  return std::abs(grid.Direction.determinant()) * grid.Spacing.prod();
}

TEST(OrthogonalResampling, ReproducesLinearImagesExactly)
{
  const auto ramp = [](const Vector3& world) { return world.dot(Vector3(1, -2, 0.5)) + 1000.0; };
  const auto sheared = Sampled<vtkFloatArray>(TiltedGrid(), ramp);
  const auto image = ResampleSheared("x", sheared, ResamplingKind::Linear);
  const ImageGrid grid = GridOf(image);
  EXPECT_FALSE(IsSheared(grid));
  EXPECT_NEAR(VoxelVolume(image), VoxelVolume(sheared), 1e-12);
  // The middle rows of a slice are within the tilted volume.
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    const Vector3 index(grid.Size[0] / 2, grid.Size[1] / 2, k);
    // Single precision of values around 1000.
    EXPECT_NEAR(image->GetScalarComponentAsDouble(int(index[0]), int(index[1]), k, 0),
                ramp(WorldOf(grid, index)), 1e-3);
  }
}

TEST(OrthogonalResampling, BoxHoldsEveryVoxel)
{
  const auto sheared =
      Sampled<vtkUnsignedCharArray>(TiltedGrid(), [](const Vector3&) { return 1; });
  const auto image = ResampleSheared("x", sheared, ResamplingKind::Nearest);
  vtkIdType inside = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    inside += image->GetPointData()->GetScalars()->GetTuple1(i) == 1.0 ? 1 : 0;
  }
  // Whole slices that only slide: up to a row and a column of each at its ends.
  EXPECT_NEAR(static_cast<double>(inside), 40 * 40 * 20, 20 * 80);
  EXPECT_EQ(image->GetDimensions()[2], 20);
}

TEST(OrthogonalResampling, LabelsKeepPlaceAndVolume)
{
  const Vector3 center(3, 14, 26);
  const double radius = 9.0;
  const auto isInside = [&](const Vector3& world) { return (world - center).norm() < radius; };
  const auto sheared = Sampled<vtkUnsignedCharArray>(TiltedGrid(), [&](const Vector3& world)
                                                     { return isInside(world) ? 3.0 : 0.0; });
  const auto image = ResampleSheared("x", sheared, ResamplingKind::Nearest);
  double count = 0.0;
  Vector3 sum = Vector3::Zero();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    if (image->GetPointData()->GetScalars()->GetTuple1(i) == 3.0)
    {
      Vector3 world;
      image->GetPoint(i, world.data());
      count += 1.0;
      sum += world;
    }
  }
  const double ball = 4.0 / 3.0 * 3.14159265358979 * radius * radius * radius;
  // Of some 1,900 voxels those at the surface may change sides by rounding: about 1 %.
  EXPECT_NEAR(count * VoxelVolume(image) / ball, 1.0, 0.02);
  EXPECT_LT((sum / count - center).norm(), 0.1);
}

// The file's body of 5.216 ml, sheared by its sform.
TEST(OrthogonalResampling, MendsShearedPublicFile)
{
  const auto path = DataPath("odd/nii_nonorth_0.2.nii.gz");
  PALPATE_REQUIRE_FILE(path);
  VolumeChoice choice;
  choice.Sheared = ShearedAxes::Resample;
  const Segmentation read = ReadSegmentation(path, choice);
  vtkImageData* image = read.Layers[0];
  double count = 0.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    count += image->GetPointData()->GetScalars()->GetTuple1(i);
  }
  EXPECT_NEAR(count * VoxelVolume(image) / 1000.0, 5.216, 0.05);
  EXPECT_TRUE(ReadImageContent(path, choice).Labels);
  ASSERT_FALSE(read.Notes.empty());
  EXPECT_EQ(read.Notes.back(), ResamplingNote);
}
} // namespace
} // namespace palpate::orthogonal_resampling_test
