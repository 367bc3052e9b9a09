#include "ScanBorder.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::scan_border_test
{
namespace
{
constexpr int Side = 24; // voxels of 1 mm

// A tube of 7 mm along the last axis of an image, in a box with a rim beyond it, up to `last`.
PlacedMask TubeUpTo(int last)
{
  PlacedMask tube;
  tube.Voxels.StartIndex = {-1, -1, -1};
  tube.Voxels.Size = {Side + 2, Side + 2, Side + 2};
  tube.Voxels.Spacing = {1.0, 1.0, 1.0};
  tube.Voxels.Inside.assign(tube.Voxels.Offset(0, 0, Side + 2), 0);
  for (int k = 6; k <= last; ++k)
  {
    for (int j = 0; j < Side; ++j)
    {
      for (int i = 0; i < Side; ++i)
      {
        const bool isIn = std::hypot(i - 11.3, j - 11.6) < 7.0;
        tube.Voxels.Inside[tube.Voxels.Offset(i + 1, j + 1, k + 1)] = isIn ? 1 : 0;
      }
    }
  }
  return tube;
}

double CutOf(const PlacedMask& mask, bool isShape)
{
  ComparedBody body;
  const Status status = isShape ? ComparedBody::OfMaskShape(mask.Voxels, mask.ToWorld, body)
                                : ComparedBody::OfMask(mask.Voxels, mask.ToWorld, body);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return CutAreaOf(body.Surface(), mask, {Side, Side, Side});
}

TEST(ScanBorder, CutHasTheAreaOfTheSection)
{
  for (const bool isShape : {false, true})
  {
    // Triangles at the edge count as wholes: half a voxel around it.
    EXPECT_NEAR(CutOf(TubeUpTo(Side - 1), isShape), M_PI * 49.0, 0.5 * 2.0 * M_PI * 7.0) << isShape;
  }
}

TEST(ScanBorder, EndInsideTheImageIsNoCut)
{
  for (const bool isShape : {false, true})
  {
    EXPECT_EQ(CutOf(TubeUpTo(Side - 4), isShape), 0.0) << isShape;
  }
}
} // namespace
} // namespace palpate::scan_border_test
