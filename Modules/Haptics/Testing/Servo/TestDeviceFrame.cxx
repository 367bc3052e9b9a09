#include "DeviceFrame.h"

#include "RandomOrientation.h"
#include "RandomShapes.h"

#include <gtest/gtest.h>

namespace palpate::device_frame_test
{
namespace
{
TEST(DeviceFrame, TranslatesScalesAndRotatesTheTool)
{
  test::Random random(612);
  for (int n = 0; n < 100; ++n)
  {
    const Matrix3 rotation = test::RandomOrientation(random);
    const Matrix3 turn = test::RandomOrientation(random); // of the tool, in the device
    const Vector3 origin = 30.0 * test::RandomDirection(random);
    const Vector3 hand = 50.0 * test::RandomDirection(random);
    const Eigen::Quaterniond orientation(turn);
    DeviceSample sample;
    sample.Position = hand;
    sample.Orientation = {orientation.x(), orientation.y(), orientation.z(), orientation.w()};
    const ToolPose pose = DeviceFrame(rotation, 2.5, origin).PoseWorld(sample);
    // Roundings of numbers of 100 mm, and of rotations.
    EXPECT_LT((pose.PositionWorld - (origin + 2.5 * (rotation * hand))).norm(), 1e-12);
    EXPECT_LT((pose.Orientation.toRotationMatrix() - rotation * turn).norm(), 1e-14);
  }
}
} // namespace
} // namespace palpate::device_frame_test
