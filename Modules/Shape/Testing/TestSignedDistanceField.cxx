#include "SignedDistanceField.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
// A box of filled voxels with two empty ones around it.
palpate::VoxelMask BoxMask(std::array<int, 3> filled, std::array<double, 3> spacing)
{
  palpate::VoxelMask mask;
  mask.Spacing = spacing;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    mask.Size[axis] = filled[axis] + 4;
  }
  mask.Inside.assign(mask.Offset(0, 0, mask.Size[2]), 0);
  for (int k = 2; k < filled[2] + 2; ++k)
  {
    for (int j = 2; j < filled[1] + 2; ++j)
    {
      std::fill_n(mask.Inside.begin() + static_cast<std::ptrdiff_t>(mask.Offset(2, j, k)),
                  filled[0], static_cast<unsigned char>(1));
    }
  }
  return mask;
}

TEST(SignedDistanceField, InterpolatesThickSlicesOnly)
{
  EXPECT_EQ(palpate::SuitableMethod(BoxMask({4, 4, 4}, {0.5, 0.5, 3.0})),
            palpate::FieldMethod::ShapeInterpolation);
  EXPECT_EQ(palpate::SuitableMethod(BoxMask({4, 4, 4}, {3.0, 0.5, 0.5})),
            palpate::FieldMethod::ShapeInterpolation);
  EXPECT_EQ(palpate::SuitableMethod(BoxMask({4, 4, 4}, {1.0, 1.0, 1.4})),
            palpate::FieldMethod::Distance);
  // Two coarse axes leave no slices to interpolate between.
  EXPECT_EQ(palpate::SuitableMethod(BoxMask({4, 4, 4}, {3.0, 3.0, 0.5})),
            palpate::FieldMethod::Distance);
}

TEST(SignedDistanceField, KeepsSideOfVoxelCentresUnsmoothed)
{
  for (const std::array<double, 3>& spacing :
       {std::array<double, 3>{0.5, 0.5, 3.0}, std::array<double, 3>{1.0, 4.0, 1.0},
        std::array<double, 3>{1.0, 1.0, 1.0}})
  {
    const palpate::VoxelMask mask = BoxMask({5, 6, 3}, spacing);
    for (const auto method : {palpate::FieldMethod::ShapeInterpolation,
                              palpate::FieldMethod::Distance, palpate::FieldMethod::Plain})
    {
      const palpate::ScalarGrid grid = palpate::BuildField(mask, method, 0.0);
      for (int k = 0; k < mask.Size[2]; ++k)
      {
        for (int j = 0; j < mask.Size[1]; ++j)
        {
          for (int i = 0; i < mask.Size[0]; ++i)
          {
            const std::array<int, 3> at{i, j, k};
            std::size_t offset = 0;
            for (int axis = 2; axis >= 0; --axis)
            {
              const auto a = static_cast<std::size_t>(axis);
              offset = offset * static_cast<std::size_t>(grid.Size[a]) +
                       static_cast<std::size_t>(std::lround(at[a] / grid.StepIndex[a]));
            }
            ASSERT_EQ(grid.Values[offset] > 0.0f, mask.Inside[mask.Offset(i, j, k)] == 1)
                << i << ' ' << j << ' ' << k;
          }
        }
      }
    }
  }
}

TEST(SignedDistanceField, RefinesOnlyCoarsestAxis)
{
  const palpate::ScalarGrid grid = palpate::BuildField(
      BoxMask({4, 4, 3}, {3.0, 0.5, 0.5}), palpate::FieldMethod::ShapeInterpolation, 0.0);
  EXPECT_EQ(grid.Size, (std::array<int, 3>{43, 8, 7})); // (8 - 1) * 6 + 1 along the first axis
  EXPECT_DOUBLE_EQ(grid.Spacing[0], 0.5);
  EXPECT_DOUBLE_EQ(grid.StepIndex[0], 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(grid.StepIndex[1], 1.0);
}
} // namespace
