#include "ControllerRumble.h"

#include <gtest/gtest.h>

namespace palpate::controller_rumble_test
{
namespace
{
TEST(ControllerRumble, NothingTouchedIsStill)
{
  EXPECT_TRUE(ControllerRumble::Of({}).IsStill());
}

TEST(ControllerRumble, PushTurnsTheSlowMotorTextureTheFastOne)
{
  TouchCue soft;
  soft.Push = 0.3;
  TouchCue rough = soft;
  rough.Texture = 0.8;
  TouchCue hard = soft;
  hard.Hardness = 1.0;
  const ControllerRumble one = ControllerRumble::Of(soft);
  EXPECT_GT(one.Slow, 20000);
  EXPECT_EQ(one.Fast, 0);
  EXPECT_EQ(ControllerRumble::Of(rough).Slow, one.Slow);
  EXPECT_GT(ControllerRumble::Of(rough).Fast, 50000);
  EXPECT_GT(ControllerRumble::Of(hard).Fast, 9000) << "what is hard is felt by itself";
}

TEST(ControllerRumble, NoCueExceedsFullPower)
{
  TouchCue most;
  most.Push = most.Texture = most.Knock = most.Hardness = 1.0;
  EXPECT_EQ(ControllerRumble::Of(most).Slow, 65535);
  EXPECT_EQ(ControllerRumble::Of(most).Fast, 65535);
}
} // namespace
} // namespace palpate::controller_rumble_test
