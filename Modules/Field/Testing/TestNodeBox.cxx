#include "NodeBox.h"

#include "RandomOrientation.h"

#include <gtest/gtest.h>

namespace palpate::node_box_test
{
namespace
{
FieldGrid Oblique(std::mt19937_64& random)
{
  return {{17, 9, 12}, {-20.0, 33.0, 5.0}, {0.8, 1.5, 1.1}, test::RandomOrientation(random)};
}

TEST(NodeBox, PartHasNodesOfTheGridRoundTheBox)
{
  std::mt19937_64 random(4401);
  std::uniform_real_distribution<double> part(-0.2, 1.2);
  const Vector3 last(16.0, 8.0, 11.0);
  int smaller = 0;
  for (int sample = 0; sample < 200; ++sample)
  {
    const FieldGrid grid = Oblique(random);
    const auto place = [&]
    { return Vector3(part(random) * 16.0, part(random) * 8.0, part(random) * 11.0); };
    const Vector3 middle = grid.PointWorld(place());
    const Eigen::AlignedBox3d box(middle - Vector3(0.3, 1.0, 2.0), middle + Vector3(0.3, 1.0, 2.0));
    const NodeBox nodes = NodesRound(grid, box, 1.0);
    if (!nodes.HasCells())
    {
      continue; // outside
    }
    const FieldGrid within = PartOf(grid, nodes);
    ASSERT_EQ(within.NodeCount(), nodes.Count());
    smaller += within.NodeCount() < grid.NodeCount() ? 1 : 0;
    const Vector3 first(nodes.First[0], nodes.First[1], nodes.First[2]);
    const Vector3 size(nodes.Last[0], nodes.Last[1], nodes.Last[2]);
    for (int n = 0; n < 8; ++n)
    {
      const Vector3 point = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(n));
      const Vector3 inGrid = grid.PointIndex(point);
      const Vector3 inPart = within.PointIndex(point);
      ASSERT_LT((inGrid - first - inPart).norm(), 1e-9); // of coordinates of 40 mm, rounded
      if ((inGrid.array() >= 0.0).all() && (inGrid.array() <= last.array()).all())
      {
        ASSERT_TRUE((inPart.array() >= 0.0).all() &&
                    (inPart.array() <= (size - first).array()).all());
      }
    }
  }
  EXPECT_GT(smaller, 100);
}

TEST(NodeBox, BoxOutsideHasNoCells)
{
  std::mt19937_64 random(4402);
  const Vector3 far = Vector3::Constant(1e4);
  EXPECT_FALSE(NodesRound(Oblique(random), {far, far + Vector3::Ones()}, 1.0).HasCells());
}
} // namespace
} // namespace palpate::node_box_test
