#include "LabelsOnGrid.h"

#include "FieldOfImage.h"
#include "LabelImages.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::labels_on_grid_test
{
namespace
{
test::LabelGrid ObliqueGrid(unsigned int seed)
{
  std::mt19937_64 random(seed);
  test::LabelGrid grid;
  grid.Size = {{20, 26, 14}};
  grid.Spacing = {{1.2, 0.8, 2.1}};
  grid.Direction = test::RandomRotation(random);
  grid.CenterOnOrigin();
  return grid;
}

bool IsInSphere(double x, double y, double z)
{
  return std::hypot(x, y, z) < 6.0;
}

TEST(LabelsOnGrid, SameGridGivesTheMapItself)
{
  const auto labels = test::MakeLabelImage(ObliqueGrid(1), IsInSphere);
  const auto image = test::MakeLabelImage<short>(ObliqueGrid(1), IsInSphere);
  EXPECT_EQ(LabelsOnGrid(labels, image), labels);
}

// The oracle searches all voxels for the nearest.
TEST(LabelsOnGrid, EqualNearestVoxelOrZeroOutside)
{
  const test::LabelGrid small = ObliqueGrid(2);
  test::LabelGrid large = ObliqueGrid(3);
  large.Size = {{9, 8, 11}};
  large.Spacing = {{4.3, 4.1, 3.7}};
  large.CenterOnOrigin();
  const auto labels = test::MakeLabelImage(small, IsInSphere, 7);
  const auto image = test::MakeLabelImage<short>(large, IsInSphere);
  const auto matched = LabelsOnGrid(labels, image);
  const FieldGrid from = GridOfImage(labels);
  const FieldGrid to = GridOfImage(image);
  ASSERT_EQ(to.Size(), GridOfImage(matched).Size());
  EXPECT_EQ(to.OriginWorld(), GridOfImage(matched).OriginWorld());
  EXPECT_EQ(to.Direction(), GridOfImage(matched).Direction());
  int inside = 0;
  int outside = 0;
  for (int k = 0; k < to.Size()[2]; ++k)
  {
    for (int j = 0; j < to.Size()[1]; ++j)
    {
      for (int i = 0; i < to.Size()[0]; ++i)
      {
        const Vector3 index = from.PointIndex(to.PointWorld(Vector3(i, j, k)));
        const Vector3 nearest = index.array().round();
        const auto size = Vector3(from.Size()[0], from.Size()[1], from.Size()[2]);
        const bool isIn = (nearest.array() >= 0.0).all() && (nearest.array() < size.array()).all();
        const double wanted = isIn ? labels->GetScalarComponentAsDouble(
                                         static_cast<int>(nearest[0]), static_cast<int>(nearest[1]),
                                         static_cast<int>(nearest[2]), 0)
                                   : 0.0;
        EXPECT_EQ(matched->GetScalarComponentAsDouble(i, j, k, 0), wanted);
        inside += wanted == 7.0 ? 1 : 0;
        outside += isIn ? 0 : 1;
      }
    }
  }
  EXPECT_GT(inside, 3);
  EXPECT_GT(outside, 100);
}
} // namespace
} // namespace palpate::labels_on_grid_test
