#include "LabelCenters.h"

#include "ImageGrid.h"
#include "SegmentCompletion.h"

#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::label_centers_test
{
namespace
{
constexpr int Side = 9;

template <typename Array, typename Paint>
Segmentation MakeSegmentation(const ImageGrid& grid, const Paint& paint)
{
  auto array = vtkSmartPointer<Array>::New();
  for (int z = 0; z < Side; ++z)
  {
    for (int y = 0; y < Side; ++y)
    {
      for (int x = 0; x < Side; ++x)
      {
        array->InsertNextValue(paint(x, y, z));
      }
    }
  }
  Segmentation segmentation;
  segmentation.Layers.push_back(MakeImage(grid, array));
  CompleteSegments(segmentation);
  return segmentation;
}

ImageGrid ObliqueGrid()
{
  ImageGrid grid;
  grid.Size = {{Side, Side, Side}};
  grid.Spacing = Vector3(0.5, 1.0, 3.0);
  grid.OriginWorld = Vector3(10.0, -20.0, 30.0);
  grid.Direction << 0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0;
  return grid;
}

TEST(LabelCenters, BoxHasItsMiddleVoxelOnAnObliqueGrid)
{
  const ImageGrid grid = ObliqueGrid();
  const Segmentation segmentation = MakeSegmentation<vtkUnsignedShortArray>(
      grid, [](int x, int y, int z) { return x <= 4 && y >= 4 && z >= 2 && z <= 4 ? 1007 : 0; });
  const auto centers = LabelCenters(segmentation);
  ASSERT_EQ(centers.size(), 1U);
  const Vector3 expected =
      grid.OriginWorld + grid.Direction * grid.Spacing.cwiseProduct(Vector3(2.0, 6.0, 3.0));
  EXPECT_NEAR((centers.at(1007) - expected).norm(), 0.0, 1e-12);
}

TEST(LabelCenters, CenterOfAHollowStructureIsOneOfItsVoxels)
{
  const auto isShell = [](int x, int y, int z) {
    return std::max({std::abs(x - 4), std::abs(y - 4), std::abs(z - 4)}) == 4;
  };
  ImageGrid grid;
  grid.Size = {{Side, Side, Side}};
  const Segmentation segmentation = MakeSegmentation<vtkUnsignedCharArray>(
      grid, [&](int x, int y, int z) { return isShell(x, y, z) ? 1 : 2; });
  const auto centers = LabelCenters(segmentation);
  const Vector3 index = (centers.at(1) - grid.OriginWorld).cwiseQuotient(grid.Spacing);
  EXPECT_TRUE(isShell(static_cast<int>(std::lround(index.x())),
                      static_cast<int>(std::lround(index.y())),
                      static_cast<int>(std::lround(index.z()))));
  EXPECT_NEAR(
      (centers.at(2) - grid.Spacing.cwiseProduct(Vector3::Constant(4.0)) - grid.OriginWorld).norm(),
      0.0, 1e-12);
}
} // namespace
} // namespace palpate::label_centers_test
