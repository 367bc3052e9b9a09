#include "StiffnessAdvice.h"

#include "TouchDoubles.h"
#include "VolumeViscosity.h"

#include <gtest/gtest.h>

#include <limits>

namespace palpate::stiffness_advice_test
{
namespace
{
DeviceCapabilities Known()
{
  DeviceCapabilities device;
  device.Name = "example";
  device.Damping = 0.002;
  device.Friction = 0.2;
  device.Resolution = 0.05;
  device.MaximumStiffness = 20.0;
  return device;
}

TEST(StiffnessAdvice, IsTheSmallestBound)
{
  DeviceCapabilities device = Known();
  // (0.002 - 0.0005) N s/mm / 0.5 ms
  EXPECT_DOUBLE_EQ(StiffestStable(device, 1000.0, 0.0005).Largest, 3.0);
  device.Delay = 0.001;
  EXPECT_DOUBLE_EQ(StiffestStable(device, 1000.0, 0.0005).Largest, 1.0);
  device.Damping = 0.0;
  EXPECT_DOUBLE_EQ(StiffestStable(device, 1000.0, 0.0005).Largest, 8.0); // 2 * 0.2 N / 0.05 mm
  device.Friction = 0.0;
  EXPECT_DOUBLE_EQ(StiffestStable(device, 1000.0, 0.0005).Largest, 20.0);
  device.MaximumStiffness = 0.0;
  EXPECT_EQ(StiffestStable(device, 1000.0, 0.0005).Largest,
            std::numeric_limits<double>::infinity());
}

TEST(StiffnessAdvice, IsZeroForDampingAboveTheDevices)
{
  EXPECT_EQ(StiffestStable(Known(), 1000.0, 0.003).Largest, 0.0);
}

TEST(StiffnessAdvice, WarnsOfEveryStructureAboveTheBound)
{
  TouchScene scene = test::WallScene(0.0, {3.9, 0.0});
  scene.Structures.push_back(scene.Structures[0]);
  scene.Structures[1].Name = "bone";
  scene.Structures[1].Law.Stiffness = 5.0;
  const std::vector<std::string> warnings = StiffnessWarnings(scene, Known(), 1000.0);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "The structure bone requests 5 N/mm; the device example at 1e+03 Hz is stable up to 4 "
            "N/mm, since its own damping cannot absorb more of the energy that sampling generates: "
            "lower its stiffness or its damping, or it may vibrate.");
}

// The mechanism's 0.002 N s/mm must absorb it, however soft the structure.
TEST(StiffnessAdvice, WarnsOfViscosityAboveTheMechanisms)
{
  TouchScene scene = test::WallScene(0.0, {0.0, 0.0});
  scene.Structures[0].Effects = {std::make_shared<const VolumeViscosity>(0.0019)};
  EXPECT_TRUE(StiffnessWarnings(scene, Known(), 1000.0).empty());
  scene.Structures[0].Effects = {std::make_shared<const VolumeViscosity>(0.0021)};
  ASSERT_EQ(StiffnessWarnings(scene, Known(), 1000.0).size(), 1u);
  EXPECT_NE(StiffnessWarnings(scene, Known(), 1000.0)[0].find("0.0021 N s/mm"), std::string::npos);
}
} // namespace
} // namespace palpate::stiffness_advice_test
