#include "IslandNeighbour.h"

#include "LabelImages.h"
#include "LabelMask.h"

#include <gtest/gtest.h>

namespace palpate::island_neighbour_test
{
namespace
{
using test::LabelGrid;

struct Block
{
  int Label;
  std::array<int, 3> First;
  std::array<int, 3> Last; // inclusive
};

// Blocks of labels in voxels of 1 x 1 x 3 mm; each layer has its blocks.
Segmentation Labels(const std::vector<std::vector<Block>>& layers)
{
  Segmentation labels;
  for (std::size_t layer = 0; layer < layers.size(); ++layer)
  {
    LabelGrid grid;
    grid.Size = {{30, 20, 12}};
    grid.Spacing = {{1.0, 1.0, 3.0}};
    const auto image = MakeLabelImage(grid, [](double, double, double) { return false; });
    for (const Block& block : layers[layer])
    {
      for (int k = block.First[2]; k <= block.Last[2]; ++k)
      {
        for (int j = block.First[1]; j <= block.Last[1]; ++j)
        {
          for (int i = block.First[0]; i <= block.Last[0]; ++i)
          {
            *static_cast<unsigned char*>(image->GetScalarPointer(i, j, k)) =
                static_cast<unsigned char>(block.Label);
          }
        }
      }
      Segment segment;
      segment.Label = segment.Value = block.Label;
      segment.Layer = static_cast<int>(layer);
      labels.Segments.push_back(segment);
    }
    labels.Layers.emplace_back(image);
  }
  return labels;
}

// Of the first structure; 0 if it touches none.
int NeighbourIn(const Segmentation& labels)
{
  const Segment& own = labels.Segments.front();
  CheckedMask mask;
  mask.Voxels = CopyLabelMask(labels.Layers[0], own.Value, 1).Mask;
  const Segment* const found = NeighbourOfIsland(labels, own, mask);
  return found != nullptr ? found->Label : 0;
}

constexpr Block Body{1, {1, 1, 1}, {8, 12, 8}};
constexpr Block Island{1, {14, 4, 4}, {17, 7, 5}};

TEST(IslandNeighbour, IsTheOneThatTheIslandTouchesMost)
{
  // Faces of 3 mm^2 to the side, of 1 mm^2 above: 4 x 2 of 3 mm^2 and 4 x 4 of 1 mm^2.
  const Block side{2, {18, 4, 4}, {25, 7, 5}};
  const Block above{3, {14, 4, 6}, {17, 7, 9}};
  EXPECT_EQ(NeighbourIn(Labels({{Body, Island, side, above}})), 2);
  // And of fewer faces to the side: 2 x 2 of 3 mm^2.
  const Block narrow{2, {18, 4, 4}, {25, 5, 5}};
  EXPECT_EQ(NeighbourIn(Labels({{Body, Island, narrow, above}})), 3);
}

TEST(IslandNeighbour, BodyDoesNotCount)
{
  const Block atBody{2, {1, 13, 1}, {8, 18, 8}};
  EXPECT_EQ(NeighbourIn(Labels({{Body, Island, atBody}})), 0);
  EXPECT_EQ(NeighbourIn(Labels({{Body, Island}})), 0);
}

TEST(IslandNeighbour, StructuresOfOtherLayersCount)
{
  const Block around{2, {12, 2, 3}, {25, 9, 9}};
  EXPECT_EQ(NeighbourIn(Labels({{Body, Island}, {around}})), 2);
}

TEST(IslandNeighbour, IslandMayEndAtTheBorderOfTheImage)
{
  const Block corner{1, {27, 17, 10}, {29, 19, 11}};
  const Block beside{2, {24, 17, 10}, {26, 19, 11}};
  EXPECT_EQ(NeighbourIn(Labels({{Body, corner, beside}})), 2);
  EXPECT_EQ(NeighbourIn(Labels({{Body, corner}})), 0);
}
} // namespace
} // namespace palpate::island_neighbour_test
