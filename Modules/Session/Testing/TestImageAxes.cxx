#include "ImageAxes.h"

#include "SyntheticFit.h"

#include <gtest/gtest.h>
#include <random>

using palpate::ImageAxes;
using palpate::IndexBox;
using palpate::Vector3;

TEST(ImageAxes, PlacesVoxelsWhereVtkDoes)
{
  const palpate::test::SyntheticFit fit;
  const ImageAxes axes(fit.Result.Mask);
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 100; ++trial)
  {
    const auto voxel = static_cast<vtkIdType>(
        random() % static_cast<std::uint64_t>(fit.Result.Mask->GetNumberOfPoints()));
    double world[3];
    fit.Result.Mask->GetPoint(voxel, world);
    const Vector3 index(static_cast<double>(voxel % 96), static_cast<double>(voxel / 96 % 96),
                        static_cast<double>(voxel / (96 * 96)));
    // Rounding of numbers around 100.
    EXPECT_NEAR((axes.ToWorld(index) - Vector3(world)).norm(), 0.0, 1e-11);
    EXPECT_NEAR((axes.ToIndex(Vector3(world)) - index).norm(), 0.0, 1e-11);
  }
}

TEST(ImageAxes, TheBoxOfAValueIsTheSmallestThatHoldsIt)
{
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 50; ++trial)
  {
    vtkNew<vtkImageData> image;
    image->SetExtent(-3, 9, 2, 12, 0, 8);
    image->AllocateScalars(VTK_SHORT, 1);
    std::fill_n(static_cast<short*>(image->GetScalarPointer()), image->GetNumberOfPoints(),
                short{1});
    Eigen::Vector3i low(1000, 1000, 1000);
    Eigen::Vector3i high(-1000, -1000, -1000);
    const int count = 1 + static_cast<int>(random() % 4);
    for (int c = 0; c < count; ++c)
    {
      const Eigen::Vector3i at(static_cast<int>(random() % 13) - 3,
                               static_cast<int>(random() % 11) + 2, static_cast<int>(random() % 9));
      *static_cast<short*>(image->GetScalarPointer(at.x(), at.y(), at.z())) = 42;
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    IndexBox box;
    ASSERT_TRUE(palpate::FindValueBox(image, 42, box));
    EXPECT_EQ(box.Low, low);
    EXPECT_EQ(box.High, high);
    EXPECT_FALSE(palpate::FindValueBox(image, 43, box));
  }
}
