#include "WorkspaceFrame.h"

#include "RandomOrientation.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::workspace_frame_test
{
namespace
{
// Some roundings of numbers of some hundred mm.
constexpr double Rounding = 1e-11;

class WorkspaceFrameTest : public testing::Test
{
protected:
  Vector3 RandomVector(double size)
  {
    std::uniform_real_distribution<double> uniform(-size, size);
    return {uniform(this->Random), uniform(this->Random), uniform(this->Random)};
  }
  WorkspaceFrame RandomFrame()
  {
    WorkspaceFrame frame;
    frame.Rotation = test::RandomOrientation(this->Random);
    frame.Scale = std::uniform_real_distribution<double>(0.5, 3.0)(this->Random);
    frame.CenterWorld = this->RandomVector(100.0);
    return frame;
  }

  std::mt19937_64 Random{20261120};
  Eigen::AlignedBox3d Workspace{Vector3(-40.0, -30.0, -20.0), Vector3(35.0, 45.0, 25.0)};
};

TEST_F(WorkspaceFrameTest, KeepsPlacesInReach)
{
  for (int n = 0; n < 200; ++n)
  {
    const WorkspaceFrame frame = this->RandomFrame();
    const Vector3 place = this->RandomVector(20.0);
    EXPECT_LT((frame.NearestInReach(frame.ToWorld(place), this->Workspace) - place).norm(),
              Rounding);
  }
}

TEST_F(WorkspaceFrameTest, FindsTheNearestPlaceInReach)
{
  for (int n = 0; n < 200; ++n)
  {
    const WorkspaceFrame frame = this->RandomFrame();
    const Vector3 target = frame.CenterWorld + this->RandomVector(400.0);
    const Vector3 found = frame.NearestInReach(target, this->Workspace);
    EXPECT_TRUE(this->Workspace.contains(found));
    const double distance = (frame.ToWorld(found) - target).norm();
    for (int other = 0; other < 50; ++other)
    {
      const Vector3 place = this->RandomVector(20.0);
      EXPECT_LE(distance, (frame.ToWorld(place) - target).norm() + Rounding);
    }
  }
}

TEST_F(WorkspaceFrameTest, HandStartsAtTheBorderTowardsTheViewer)
{
  for (int n = 0; n < 200; ++n)
  {
    const WorkspaceFrame frame = this->RandomFrame();
    const Vector3 viewer = this->RandomVector(1.0);
    const Vector3 first = frame.FirstHand(viewer, this->Workspace);
    EXPECT_NEAR(this->Workspace.squaredExteriorDistance(first), 0.0, Rounding);
    EXPECT_FALSE(this->Workspace.contains(Vector3(1.001 * first)));
    const Vector3 path = frame.ToWorld(first) - frame.CenterWorld;
    EXPECT_NEAR(path.normalized().dot(viewer.normalized()), 1.0, Rounding);
  }
}

TEST_F(WorkspaceFrameTest, HandFacingAScreenStartsAtTheFrontCentre)
{
  WorkspaceFrame frame = this->RandomFrame();
  frame.Rotation = Matrix3::Identity();
  EXPECT_EQ(frame.FirstHand(Vector3::UnitZ(), this->Workspace), Vector3(0.0, 0.0, 25.0));
}

TEST_F(WorkspaceFrameTest, UnknownWorkspaceIsUnlimited)
{
  const WorkspaceFrame frame;
  const Vector3 far(1e6, 0.0, -1e6);
  EXPECT_EQ(frame.NearestInReach(far, {}), far);
  EXPECT_EQ(frame.FirstHand(Vector3::UnitZ(), {}), Vector3::Zero());
}
} // namespace
} // namespace palpate::workspace_frame_test
