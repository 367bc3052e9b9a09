#include "SliceImage.h"

#include "ImageAxes.h"
#include "SyntheticFit.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::slice_image_test
{
namespace
{
const Vector3 Slope(0.3, -0.7, 0.2);

// Values Slope . x (world) on a rotated grid.
vtkSmartPointer<vtkImageData> MakeLinearImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(50, 60, 40);
  image->SetSpacing(2.0, 1.7, 2.3);
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows =
      Eigen::AngleAxisd(0.6, Vector3(2, 1, 1).normalized()).toRotationMatrix();
  image->SetDirectionMatrix(rows.data());
  image->AllocateScalars(VTK_DOUBLE, 1);
  const Vector3 middle = palpate::ImageAxes(image).ToWorld(Vector3(24.5, 29.5, 19.5));
  const Vector3 origin = palpate::test::SyntheticFit::Center - middle;
  image->SetOrigin(origin.x(), origin.y(), origin.z());
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    double point[3];
    image->GetPoint(p, point);
    static_cast<double*>(image->GetScalarPointer())[p] = Slope.dot(Vector3(point));
  }
  return image;
}

TEST(SliceImage, ReproducesLinearImageOnOtherGrid)
{
  const palpate::test::SyntheticFit fit;
  const auto image = MakeLinearImage();
  int inside = 0;
  for (const SlicePlane& plane : palpate::ChooseSlicePlanes(fit.Result.Mask, 1, 2, 90))
  {
    const std::vector<float> values = palpate::SampleLinear(image, plane);
    for (int row = 0; row < plane.Height; ++row)
    {
      for (int column = 0; column < plane.Width; ++column)
      {
        const float value = values[static_cast<std::size_t>(row * plane.Width + column)];
        const Vector3 world = plane.ToWorld({column + 0.5, row + 0.5});
        const Vector3 index = palpate::ImageAxes(image).ToIndex(world);
        const bool isWithinCentres =
            index.minCoeff() > 0.0 && index.x() < 49.0 && index.y() < 59.0 && index.z() < 39.0;
        if (isWithinCentres)
        {
          // Linear interpolation of a linear function; floats near 70 have a resolution of 4e-6.
          ASSERT_NEAR(value, Slope.dot(world), 5e-5);
          ++inside;
        }
      }
    }
  }
  EXPECT_GT(inside, 10000);
}

TEST(SliceImage, IsNanOutsideImage)
{
  const palpate::test::SyntheticFit fit;
  SlicePlane plane = palpate::ChooseSlicePlanes(fit.Result.Mask, 1, 1, 50).front();
  plane.CornerWorld += Vector3(5000.0, 0.0, 0.0);
  for (const float value : palpate::SampleLinear(fit.Mri.Image, plane))
  {
    ASSERT_TRUE(std::isnan(value));
  }
  for (const float value : palpate::SampleNearest(fit.Result.Mask, plane))
  {
    ASSERT_EQ(value, 0.0F);
  }
}

TEST(SliceImage, NearestSamplesUseVoxelAtPoint)
{
  const palpate::test::SyntheticFit fit;
  const SlicePlane plane = palpate::ChooseSlicePlanes(fit.Result.Mask, 1, 1, 77).front();
  const std::vector<float> values = palpate::SampleNearest(fit.Result.Mask, plane);
  const palpate::ImageAxes axes(fit.Result.Mask);
  for (int row = 0; row < plane.Height; ++row)
  {
    for (int column = 0; column < plane.Width; ++column)
    {
      const Vector3 index = axes.ToIndex(plane.ToWorld({column + 0.5, row + 0.5}));
      const Eigen::Vector3i voxel = index.array().round().matrix().cast<int>();
      if ((index - voxel.cast<double>()).head<2>().cwiseAbs().maxCoeff() < 0.499)
      {
        ASSERT_EQ(values[static_cast<std::size_t>(row * plane.Width + column)],
                  fit.Result.Mask->GetScalarComponentAsDouble(voxel.x(), voxel.y(), voxel.z(), 0));
      }
    }
  }
}

TEST(SliceImage, GreyRunsFromBlackToWhiteAndNanIsBlack)
{
  SlicePlane plane;
  plane.Width = 4;
  plane.Height = 1;
  const palpate::RasterImage raster = palpate::DrawGrey(
      {10.0F, 20.0F, 15.0F, std::numeric_limits<float>::quiet_NaN()}, plane, {10.0, 20.0});
  EXPECT_EQ(raster.Pixel(0, 0)[0], 0);
  EXPECT_EQ(raster.Pixel(1, 0)[1], 255);
  EXPECT_NEAR(raster.Pixel(2, 0)[2], 127, 1);
  EXPECT_EQ(raster.Pixel(3, 0)[0], 0);
  EXPECT_EQ(raster.Pixel(3, 0)[3], 255);
}
} // namespace
} // namespace palpate::slice_image_test
