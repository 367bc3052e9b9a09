#include "AllocationCounter.h"
#include "FeltCases.h"
#include "GuidingGradient.h"
#include "ManyStructures.h"
#include "ServoRun.h"
#include "StiffnessImage.h"
#include "StructureGuide.h"
#include "SurfaceTexture.h"
#include "TexturedField.h"
#include "VolumeViscosity.h"

#include <gtest/gtest.h>

#include <utility>

namespace palpate::servo_does_not_allocate_test
{
namespace
{
static_assert(noexcept(std::declval<Servo&>().Tick(std::declval<const TickInfo&>())));

// Keeps the tool at a distance from a sphere of 10 mm.
std::shared_ptr<const ForceField> GuideByDistance()
{
  const auto field = test::FeltField(
      test::FeltGrid(50), [](const Vector3& place) { return place.norm() - 10.0; },
      FieldInterpolation::TricubicBSpline);
  std::shared_ptr<const StructureDistance> distance;
  EXPECT_TRUE(StructureDistance::Make(field, 12.0, distance).IsOk());
  GuideSettings settings;
  settings.Shape = GuideShape::Surface;
  settings.Structure = 1;
  settings.Range = 12.0;
  std::shared_ptr<const StructureGuide> guide;
  EXPECT_TRUE(StructureGuide::Make(settings, distance, guide).IsOk());
  return guide;
}

// In and out of a wall, through a new scene, continued scenes, a fault and its end.
std::size_t AllocationsOfASession(const ServoSettings& settings)
{
  TouchScene scene = test::WallScene(0.0, {1.0, 0.01});
  std::shared_ptr<const SurfaceTexture> texture;
  EXPECT_TRUE(
      SurfaceTexture::Make(test::TexturedField(), 0, test::TexturedBox(), 0.2, texture).IsOk());
  std::shared_ptr<const StiffnessImage> stiffness;
  EXPECT_TRUE(
      StiffnessImage::Make(test::TexturedField(), 0, {-1.0, 1.0, 0.5, 2.0}, stiffness).IsOk());
  GuidingSettings guiding;
  guiding.ToIntensity = guiding.Energy = 1.0;
  std::shared_ptr<const GuidingGradient> gradient;
  EXPECT_TRUE(GuidingGradient::Make(test::TexturedField(), 0, guiding, gradient).IsOk());
  scene.Structures[0].Effects = {texture, std::make_shared<const VolumeViscosity>(0.001), stiffness,
                                 gradient};
  scene.Fields = {GuideByDistance()};
  test::ServoRun run(scene, settings);
  TouchScene continued = test::WallScene(0.5, {1.0, 0.0});
  continued.Structures[0].Id = 1;
  std::size_t publishing = 0;
  const std::size_t before = test::AllocationCount();
  for (int n = 0; n < 2000; ++n)
  {
    run.TickAt({0.0, 0.0, 2.0 * std::cos(0.02 * n)});
    if (n == 500)
    {
      const std::size_t start = test::AllocationCount();
      EXPECT_TRUE(run.Loop.Publish(std::make_shared<TouchScene>(continued)).IsOk());
      publishing += test::AllocationCount() - start;
    }
    if (n == 700 || n == 1700)
    {
      const std::size_t start = test::AllocationCount();
      EXPECT_TRUE(
          run.Loop.Publish(std::make_shared<TouchScene>(continued), SceneEntry::Continuing).IsOk());
      publishing += test::AllocationCount() - start;
    }
    if (n == 1000)
    {
      run.TickAt({test::NotANumber, 0.0, 0.0});
      run.Loop.Rearm();
    }
  }
  EXPECT_EQ(run.Loop.Latest().Scene, 4u);
  return test::AllocationCount() - before - publishing;
}

TEST(ServoDoesNotAllocate, InAnyTick)
{
  ServoSettings settings;
  EXPECT_EQ(AllocationsOfASession(settings), 0u);
  settings.ModelInterval = 3;
  EXPECT_EQ(AllocationsOfASession(settings), 0u);
}

TEST(ServoDoesNotAllocate, WhileAFaultEndsByItself)
{
  DeviceCapabilities device = test::ScriptedDevice().Abilities;
  device.HasMotors = false;
  test::ServoRun run(test::WallScene(0.0, {1.0, 0.01}), ServoSettings(), device);
  run.RestAt({0.0, 0.0, -1.0});
  const std::size_t before = test::AllocationCount();
  run.Device.RepeatsSample = true;
  run.TickAt({0.0, 0.0, -1.0});
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_TRUE(run.Loop.Latest().Safety.WillResume);
  run.Device.RepeatsSample = false;
  run.RestAt({0.0, 0.0, -1.0});
  EXPECT_TRUE(run.Loop.Latest().Safety.IsArmed);
  EXPECT_EQ(test::AllocationCount(), before);
}

TEST(ServoDoesNotAllocate, AmongManyStructures)
{
  test::ServoRun run(test::ManyStructures(300));
  test::Random random(7103);
  Vector3 place = Vector3::Zero();
  int touches = 0;
  const std::size_t before = test::AllocationCount();
  for (int tick = 0; tick < 3000; ++tick)
  {
    place += (tick % 100 == 0 ? 3.0 : 0.05) * test::RandomDirection(random) - 0.01 * place;
    run.TickAt(place);
    touches += run.Loop.Latest().Structure >= 0 ? 1 : 0;
  }
  EXPECT_EQ(test::AllocationCount(), before);
  EXPECT_GT(touches, 300);
}
} // namespace
} // namespace palpate::servo_does_not_allocate_test
