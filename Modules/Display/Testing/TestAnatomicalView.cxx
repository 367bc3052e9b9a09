#include "AnatomicalView.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace palpate::anatomical_view_test
{
namespace
{
TEST(AnatomicalView, FramesAreRightHandedAndOrthonormal)
{
  for (const ViewSide side : palpate::AllViewSides)
  {
    const palpate::ViewFrame frame = FrameOf(side);
    EXPECT_EQ(frame.RightWorld.cross(frame.UpWorld), frame.TowardsViewerWorld);
    EXPECT_EQ(frame.RightWorld.norm(), 1.0);
    EXPECT_EQ(frame.UpWorld.norm(), 1.0);
  }
}

TEST(AnatomicalView, ViewerIsOnNamedSide)
{
  for (const ViewSide side : palpate::AllViewSides)
  {
    EXPECT_EQ(OrientationLetters(FrameOf(side).TowardsViewerWorld),
              palpate::NameOf(side).substr(0, 1));
  }
}

TEST(AnatomicalView, FollowsRadiologicalConvention)
{
  EXPECT_EQ(OrientationLetters(FrameOf(ViewSide::Anterior).RightWorld), "L");
  EXPECT_EQ(OrientationLetters(FrameOf(ViewSide::Posterior).RightWorld), "R");
  EXPECT_EQ(OrientationLetters(FrameOf(ViewSide::Left).RightWorld), "P");
  EXPECT_EQ(OrientationLetters(FrameOf(ViewSide::Right).RightWorld), "A");
  EXPECT_EQ(OrientationLetters(FrameOf(ViewSide::Inferior).RightWorld), "L");
  EXPECT_EQ(OrientationLetters(FrameOf(ViewSide::Superior).RightWorld), "R");
  EXPECT_EQ(OrientationLetters(FrameOf(ViewSide::Inferior).UpWorld), "A");
  EXPECT_EQ(OrientationLetters(FrameOf(ViewSide::Left).UpWorld), "S");
}

TEST(AnatomicalView, EdgeLettersMatchDirections)
{
  using Letters = std::array<std::string, 4>; // left, right, top, bottom
  EXPECT_EQ(EdgeLettersOf(FrameOf(ViewSide::Inferior)), (Letters{"R", "L", "A", "P"}));
  EXPECT_EQ(EdgeLettersOf(FrameOf(ViewSide::Left)), (Letters{"A", "P", "S", "I"}));
}

TEST(AnatomicalView, ObliqueDirectionsListLargestComponentFirst)
{
  EXPECT_EQ(OrientationLetters(Vector3(0.6, 0.8, 0.0)), "PL");
  EXPECT_EQ(OrientationLetters(Vector3(-0.2, -0.1, -0.97)), "I");
  EXPECT_EQ(OrientationLetters(Vector3::Zero()), "");
}
} // namespace
} // namespace palpate::anatomical_view_test
