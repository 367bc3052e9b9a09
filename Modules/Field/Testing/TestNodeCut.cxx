#include "NodeCut.h"

#include <gtest/gtest.h>

namespace palpate::node_cut_test
{
namespace
{
const FieldCondition Bone{0, 300.0, FieldSense::AtLeast};
const FieldCondition Air{0, 300.0, FieldSense::AtMost};

TEST(NodeCut, RemainingSurfaceIsTheTools)
{
  const NodeCut cut(Bone, 1000.0, 0.5);
  EXPECT_GE(cut.Apply(1500.0, 1e-9), Bone.Iso);
  EXPECT_LT(cut.Apply(1500.0, -1e-9), Bone.Iso);
  EXPECT_DOUBLE_EQ(cut.Apply(1500.0, 0.2), 500.0);
}

TEST(NodeCut, ChangesNothingAwayFromTheTool)
{
  const NodeCut cut(Bone, 1000.0, 0.5);
  EXPECT_EQ(cut.Apply(1500.0, 1.3), 1500.0);
  EXPECT_EQ(cut.Apply(250.0, 0.01), 250.0);
}

TEST(NodeCut, NeverRestoresMaterial)
{
  const NodeCut cut(Bone, 1000.0, 0.5);
  for (const double value : {-1000.0, 0.0, 299.0, 300.0, 2000.0})
  {
    for (double distance = -2.0; distance < 2.0; distance += 0.05)
    {
      EXPECT_LE(cut.Apply(value, distance), value);
    }
  }
}

TEST(NodeCut, ValuesInsideTheToolStopAtTheFloor)
{
  const NodeCut cut(Bone, 1000.0, 0.5);
  EXPECT_EQ(cut.Apply(2000.0, -5.0), -200.0);
  EXPECT_EQ(cut.Apply(2000.0, -0.5), -200.0);
}

TEST(NodeCut, IsIdempotent)
{
  const NodeCut cut(Bone, 1000.0, 0.5);
  for (double distance = -2.0; distance < 2.0; distance += 0.05)
  {
    const double once = cut.Apply(1500.0, distance);
    EXPECT_EQ(cut.Apply(once, distance), once);
  }
}

TEST(NodeCut, AtMostIsTheMirrorImageOfAtLeast)
{
  const NodeCut bone(Bone, 1000.0, 0.5);
  const NodeCut air(Air, 1000.0, 0.5);
  for (double distance = -2.0; distance < 2.0; distance += 0.05)
  {
    EXPECT_DOUBLE_EQ(bone.Apply(1500.0, distance) - Bone.Iso,
                     Bone.Iso - air.Apply(-900.0, distance));
  }
}
} // namespace
} // namespace palpate::node_cut_test
