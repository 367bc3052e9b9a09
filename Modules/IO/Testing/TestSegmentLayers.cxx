#include "SegmentLayers.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::segment_layers_test
{
namespace
{
ImageGrid Row()
{
  ImageGrid grid;
  grid.Size = {{400, 1, 1}};
  return grid;
}

vtkDataArray* VoxelsOf(const SegmentLayers& layers, std::size_t layer)
{
  return layers.Images().at(layer)->GetPointData()->GetScalars();
}

// Each voxel is a segment, and the last one also of its own layer.
TEST(SegmentLayers, TakeAByteAVoxelUntilALabelNeedsMore)
{
  SegmentLayers layers("row", Row(), 1, std::numeric_limits<double>::infinity());
  for (int label = 1; label <= 255; ++label)
  {
    EXPECT_EQ(layers.Add(label, {{label, 1}}), 0);
  }
  EXPECT_EQ(layers.Add(200, {{7, 1}}), 1);
  EXPECT_EQ(VoxelsOf(layers, 0)->GetDataTypeSize(), 1);
  for (int label = 256; label <= 300; ++label)
  {
    EXPECT_EQ(layers.Add(label, {{label, 1}}), 0);
  }
  for (std::size_t layer = 0; layer < 2; ++layer)
  {
    EXPECT_EQ(VoxelsOf(layers, layer)->GetDataTypeSize(), 2);
  }
  for (int voxel = 0; voxel < 400; ++voxel)
  {
    EXPECT_EQ(VoxelsOf(layers, 0)->GetTuple1(voxel), voxel <= 300 ? voxel : 0);
    EXPECT_EQ(VoxelsOf(layers, 1)->GetTuple1(voxel), voxel == 7 ? 200 : 0);
  }
  EXPECT_EQ(layers.Shared({{299, 2}}).size(), 2U);
  layers.Add(70000, {{399, 1}});
  EXPECT_EQ(VoxelsOf(layers, 0)->GetTuple1(399), 70000);
}
} // namespace
} // namespace palpate::segment_layers_test
