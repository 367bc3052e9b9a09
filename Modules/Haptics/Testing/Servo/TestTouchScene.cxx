#include "TouchScene.h"

#include "SafetyCases.h"
#include "TouchDoubles.h"
#include "VolumeViscosity.h"

#include <gtest/gtest.h>

#include <functional>

namespace palpate::touch_scene_test
{
namespace
{
TEST(TouchScene, RejectsInvalidScenes)
{
  const std::vector<std::function<void(TouchScene&)>> spoilers{
      [](TouchScene& s) { s.Structures[0].Model = nullptr; },
      [](TouchScene& s) { s.Structures[0].Law.Stiffness = test::NotANumber; },
      [](TouchScene& s) { s.Structures[0].Law.Stiffness = -1.0; },
      [](TouchScene& s) { s.Structures[0].Law.Damping = test::Infinite; },
      [](TouchScene& s) { s.Structures[0].Law.Relaxation = -0.001; },
      [](TouchScene& s)
      { s.Structures[0].Effects = {std::make_shared<const VolumeViscosity>(-1.0)}; },
      [](TouchScene& s)
      { s.Structures[0].Effects = {std::make_shared<const VolumeViscosity>(test::NotANumber)}; },
      [](TouchScene& s) { s.Tool = ToolShape::Sphere(-1.0); },
      [](TouchScene& s) { s.Frame = DeviceFrame(-Matrix3::Identity(), 1.0, Vector3::Zero()); },
      [](TouchScene& s) { s.Frame = DeviceFrame(2.0 * Matrix3::Identity(), 1.0, Vector3::Zero()); },
      [](TouchScene& s) { s.Frame = DeviceFrame(Matrix3::Identity(), 0.0, Vector3::Zero()); },
      [](TouchScene& s) {
        s.Frame = DeviceFrame(Matrix3::Identity(), 1.0, {0.0, 0.0, test::NotANumber});
      }};
  const TouchScene good = test::WallScene(0.0, {1.0, 0.01});
  ASSERT_TRUE(good.Check().IsOk());
  for (std::size_t i = 0; i < spoilers.size(); ++i)
  {
    TouchScene scene = good;
    spoilers[i](scene);
    EXPECT_FALSE(scene.Check().IsOk()) << i;
  }
}

TEST(TouchScene, AcceptsZeroAndVeryLargeStiffness)
{
  for (const double stiffness : {0.0, 1e4})
  {
    EXPECT_TRUE(test::WallScene(0.0, {stiffness, 0.0}).Check().IsOk());
  }
}
} // namespace
} // namespace palpate::touch_scene_test
