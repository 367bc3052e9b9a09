#include "IslandNeighbours.h"

#include "CheckCases.h"

#include <gtest/gtest.h>

namespace palpate::island_neighbours_test
{
namespace
{
using namespace palpate::test;

struct Block
{
  std::array<int, 3> First;
  std::array<int, 3> Last; // inclusive
};

// Structures of blocks in voxels of 1 x 1 x 3 mm.
CaseMasks Structures(const std::vector<std::vector<Block>>& blocks)
{
  CaseMasks masks;
  for (std::size_t n = 0; n < blocks.size(); ++n)
  {
    masks.Structures.push_back({"", static_cast<int>(n) + 1, 0});
  }
  masks.MaskOf = [blocks](std::size_t n)
  {
    return MakeMask({30, 20, 12}, {1.0, 1.0, 3.0},
                    [&](const Vector3& at)
                    {
                      const Vector3 voxel = at.cwiseQuotient(Vector3(1.0, 1.0, 3.0));
                      return std::any_of(blocks[n].begin(), blocks[n].end(),
                                         [&voxel](const Block& block)
                                         {
                                           bool isIn = true;
                                           for (int axis = 0; axis < 3; ++axis)
                                           {
                                             const auto i = static_cast<std::size_t>(axis);
                                             isIn = isIn && voxel[axis] > block.First[i] - 0.5 &&
                                                    voxel[axis] < block.Last[i] + 0.5;
                                           }
                                           return isIn;
                                         });
                    });
  };
  return masks;
}

// Of the first structure; empty if its island touches none.
std::optional<std::string> NeighbourIn(const std::vector<std::vector<Block>>& blocks)
{
  const CheckedCase patient = MeasureCase(Structures(blocks), RadialProbe(), 1);
  return Find(patient.Organs.front().Measured.Statistics, "part").Other;
}

const Block Body{{1, 1, 1}, {8, 12, 8}};
const Block Island{{14, 4, 4}, {17, 7, 5}};

TEST(IslandNeighbours, TheOneThatTheIslandTouchesMostIsNamed)
{
  // Faces of 3 mm^2 to the side, of 1 mm^2 above: 4 x 2 of 3 mm^2 and 4 x 4 of 1 mm^2.
  const Block side{{18, 4, 4}, {25, 7, 5}};
  const Block above{{14, 4, 6}, {17, 7, 9}};
  EXPECT_EQ(NeighbourIn({{Body, Island}, {side}, {above}}), "label 2");
  // And of fewer faces to the side: 2 x 2 of 3 mm^2.
  const Block narrow{{18, 4, 4}, {25, 5, 5}};
  EXPECT_EQ(NeighbourIn({{Body, Island}, {narrow}, {above}}), "label 3");
}

TEST(IslandNeighbours, BodyDoesNotCount)
{
  const Block atBody{{1, 13, 1}, {8, 18, 8}};
  EXPECT_EQ(NeighbourIn({{Body, Island}, {atBody}}), "");
  EXPECT_FALSE(NeighbourIn({{Body, Island}})); // alone, none is looked for
  EXPECT_FALSE(NeighbourIn({{Body}, {Island}}));
}

TEST(IslandNeighbours, IslandMayEndAtTheBorderOfTheImage)
{
  const Block corner{{27, 17, 10}, {29, 19, 11}};
  const Block beside{{24, 17, 10}, {26, 19, 11}};
  EXPECT_EQ(NeighbourIn({{Body, corner}, {beside}}), "label 2");
}
} // namespace
} // namespace palpate::island_neighbours_test
