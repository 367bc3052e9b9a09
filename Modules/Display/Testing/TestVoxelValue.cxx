#include "VoxelValue.h"

#include "ImageAxes.h"
#include "LabelImages.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::voxel_value_test
{
namespace
{
// Every voxel has a unique value, on a rotated grid.
vtkSmartPointer<vtkImageData> NumberedImage(std::mt19937_64& random)
{
  test::LabelGrid grid;
  grid.Size = {{5, 6, 7}};
  grid.Spacing = {{0.5, 1.0, 3.0}};
  grid.Direction = test::RandomRotation(random);
  grid.CenterOnOrigin();
  auto image = test::MakeLabelImage<float>(grid, [](double, double, double) { return true; });
  for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
  {
    static_cast<float*>(image->GetScalarPointer())[v] = static_cast<float>(v);
  }
  return image;
}

TEST(VoxelValue, EqualsVoxelAtPoint)
{
  std::mt19937_64 random(3);
  const auto image = NumberedImage(random);
  const ImageAxes axes(image);
  std::uniform_real_distribution<double> within(-0.49, 0.49);
  for (int voxel = 0; voxel < 5 * 6 * 7; ++voxel)
  {
    const int slice = voxel / 30;
    const int row = voxel / 5 % 6;
    const Vector3 index(voxel % 5, row, slice);
    const Vector3 offset(within(random), within(random), within(random));
    const auto value = VoxelValueAt(image, axes.ToWorld(index + offset));
    ASSERT_TRUE(value.has_value());
    EXPECT_EQ(*value, voxel);
  }
}

TEST(VoxelValue, IsEmptyOutsideImage)
{
  std::mt19937_64 random(4);
  const auto image = NumberedImage(random);
  const ImageAxes axes(image);
  EXPECT_FALSE(VoxelValueAt(image, axes.ToWorld({-0.51, 0.0, 0.0})).has_value());
  EXPECT_FALSE(VoxelValueAt(image, axes.ToWorld({0.0, 0.0, 6.51})).has_value());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(VoxelValueAt(image, {nan, 0.0, 0.0}).has_value());
  EXPECT_FALSE(
      VoxelValueAt(image, {0.0, std::numeric_limits<double>::infinity(), 0.0}).has_value());
}
} // namespace
} // namespace palpate::voxel_value_test
