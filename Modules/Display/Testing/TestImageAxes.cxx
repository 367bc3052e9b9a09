#include "ImageAxes.h"

#include "LabelImages.h"
#include "SurfaceCut.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::image_axes_test
{
namespace
{
TEST(ImageAxes, VoxelPositionsEqualVtk)
{
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 100; ++trial)
  {
    palpate::test::LabelGrid grid;
    grid.Size = {{13, 8, 9}};
    grid.Spacing = {{0.8, 0.7, 3.0}};
    grid.Origin = {{10.0, -80.0, 55.0}};
    grid.Direction = palpate::test::RandomRotation(random);
    const auto image =
        palpate::test::MakeLabelImage(grid, [](double, double, double) { return true; });
    const ImageAxes axes(image);
    const auto voxel = static_cast<vtkIdType>(random() % (13 * 8 * 9));
    double world[3];
    image->GetPoint(voxel, world);
    const Vector3 index(static_cast<double>(voxel % 13), static_cast<double>(voxel / 13 % 8),
                        static_cast<double>(voxel / (13 * 8)));
    // Rounding of numbers around 100.
    EXPECT_NEAR((axes.ToWorld(index) - Vector3(world)).norm(), 0.0, 1e-11);
    EXPECT_NEAR((axes.ToIndex(Vector3(world)) - index).norm(), 0.0, 1e-11);
  }
}

TEST(ImageAxes, CornersAreHalfAVoxelBeyondOutermostCentres)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(-3, 9, 2, 12, 0, 8);
  image->SetSpacing(2.0, 1.0, 4.0);
  const auto corners = ImageAxes(image).CornersWorld();
  EXPECT_EQ(corners[0], Vector3(-7.0, 1.5, -2.0));
  EXPECT_EQ(corners[5], Vector3(19.0, 1.5, 34.0));
  EXPECT_EQ(corners[7], Vector3(19.0, 12.5, 34.0));
}

TEST(ImageAxes, BoxOfCornersIsCutInItsCrossSection)
{
  // A box of 20 x 10 x 6 mm around (1, 2, 3).
  std::array<Vector3, 8> corners;
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    corners[c] =
        Vector3((c & 1U) != 0 ? 11.0 : -9.0, (c & 2U) != 0 ? 7.0 : -3.0, (c & 4U) != 0 ? 6.0 : 0.0);
  }
  const auto box = palpate::MakeBox(corners);
  const auto curves = palpate::CutSurface(box, Vector3(0.0, 0.0, 2.5), Vector3::UnitZ());
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves.front().IsClosed);
  const std::vector<Vector3>& outline = curves.front().Points;
  double length = 0.0;
  for (std::size_t p = 0; p < outline.size(); ++p)
  {
    length += (outline[(p + 1) % outline.size()] - outline[p]).norm();
  }
  EXPECT_NEAR(length, 2.0 * (20.0 + 10.0), 1e-12);
  EXPECT_TRUE(palpate::CutSurface(box, Vector3(0.0, 0.0, 6.5), Vector3::UnitZ()).empty());
}
} // namespace
} // namespace palpate::image_axes_test
