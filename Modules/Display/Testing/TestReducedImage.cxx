#include "ReducedImage.h"

#include "LabelImages.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

namespace palpate::reduced_image_test
{
namespace
{
test::LabelGrid Oblique(const std::array<int, 3>& size)
{
  test::LabelGrid grid;
  grid.Size = size;
  grid.Spacing = {{0.8, 1.1, 2.5}};
  grid.Origin = {{12.0, -7.0, 30.0}};
  std::mt19937_64 random(12);
  grid.Direction = test::RandomRotation(random);
  return grid;
}

double Ramp(const double* world)
{
  return 100.0 + 0.6 * world[0] - 0.9 * world[1] + 0.7 * world[2];
}

// A linear function of the world, in the second of two components too.
vtkSmartPointer<vtkImageData> RampImage(const std::array<int, 3>& size, int components)
{
  const auto grid = Oblique(size);
  const auto image =
      test::MakeLabelImage<float>(grid, [](double, double, double) { return false; });
  image->AllocateScalars(VTK_FLOAT, components);
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    double world[3];
    image->GetPoint(p, world);
    for (int c = 0; c < components; ++c)
    {
      static_cast<float*>(image->GetScalarPointer())[p * components + c] =
          static_cast<float>(Ramp(world) + 1000.0 * c);
    }
  }
  return image;
}

// The average of a linear function over a block is its value at the block's centre.
void ExpectRamp(vtkImageData* image)
{
  ASSERT_EQ(image->GetNumberOfScalarComponents(), 1);
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    double world[3];
    image->GetPoint(p, world);
    EXPECT_NEAR(static_cast<float*>(image->GetScalarPointer())[p], Ramp(world), 1e-3);
  }
}

TEST(ReducedImage, AveragesBlocksInTheFrameOfTheImage)
{
  const auto reduced = ReducedImage(RampImage({{17, 12, 9}}, 1), 100.0);
  const int* size = reduced->GetDimensions();
  EXPECT_EQ(size[0], 5);
  EXPECT_EQ(size[1], 4);
  EXPECT_EQ(size[2], 3);
  ExpectRamp(reduced);
}

TEST(ReducedImage, SingleSlicesStayWhereTheyAre)
{
  const auto reduced = ReducedImage(RampImage({{40, 30, 1}}, 1), 200.0);
  EXPECT_EQ(reduced->GetDimensions()[2], 1);
  EXPECT_LE(reduced->GetNumberOfPoints(), 200);
  ExpectRamp(reduced);
}

TEST(ReducedImage, SmallImagesAreShared)
{
  const auto image = RampImage({{6, 5, 4}}, 1);
  const auto reduced = ReducedImage(image, 120.0);
  EXPECT_EQ(reduced->GetScalarPointer(), image->GetScalarPointer());
  EXPECT_NE(reduced, image);
}

TEST(ReducedImage, FirstComponentIsTaken)
{
  ExpectRamp(ReducedImage(RampImage({{6, 5, 4}}, 2), 1e6));
  ExpectRamp(ReducedImage(RampImage({{6, 5, 4}}, 2), 20.0));
}
} // namespace
} // namespace palpate::reduced_image_test
