#include "StopProof.h"

#include <gtest/gtest.h>

namespace palpate::stop_proof_test
{
namespace
{
constexpr std::int64_t Period = 1'000'000; // ns

// Ticks with these forces (N), one a period from time 0 on.
std::vector<TouchState> TicksOf(const std::vector<double>& forces)
{
  std::vector<TouchState> ticks(forces.size());
  for (std::size_t n = 0; n < forces.size(); ++n)
  {
    ticks[n].Tick.Started = static_cast<std::int64_t>(n) * Period;
    ticks[n].State = DeviceState::Ready;
    ticks[n].WasTaken = true;
    ticks[n].ForceDevice.Z = forces[n];
  }
  return ticks;
}

TEST(StopProof, PassesIfTheFirstOrSecondTickAfterItHasNoForce)
{
  const StopProof first = StopProof::Of(TicksOf({2.0, 1.5, 0.0, 0.0}), 2 * Period);
  EXPECT_TRUE(first.IsPassed());
  EXPECT_EQ(first.Ticks, 1);
  EXPECT_EQ(first.ForceBefore, 1.5);
  EXPECT_EQ(first.Delay, 0);
  const StopProof second = StopProof::Of(TicksOf({2.0, 1.5, 1.0, 0.0, 0.0}), Period + 1);
  EXPECT_TRUE(second.IsPassed());
  EXPECT_EQ(second.Ticks, 2);
  EXPECT_EQ(second.Delay, 2 * Period - 1);
}

TEST(StopProof, FailsForAThirdTickAndForAForceThatComesBack)
{
  EXPECT_FALSE(StopProof::Of(TicksOf({2.0, 2.0, 2.0, 0.0, 0.0}), Period).IsPassed());
  EXPECT_FALSE(StopProof::Of(TicksOf({2.0, 0.0, 0.0, 1e-9}), Period).IsPassed());
  EXPECT_FALSE(StopProof::Of(TicksOf({2.0, 2.0, 2.0}), Period).IsPassed()) << "it never ends";
}

TEST(StopProof, ProvesNothingWithoutForceOrTicksAfterIt)
{
  EXPECT_FALSE(StopProof::Of(TicksOf({0.05, 0.0, 0.0}), Period).IsPassed());
  EXPECT_FALSE(StopProof::Of(TicksOf({2.0, 2.0}), 2 * Period).IsPassed());
  EXPECT_FALSE(StopProof::Of(TicksOf({2.0, 0.0}), Period).IsPassed());
  EXPECT_FALSE(StopProof::Of({}, 0).IsPassed());
}

TEST(StopProof, CountsAForceThatTheDeviceDidNotTakeAsStillActing)
{
  std::vector<TouchState> ticks = TicksOf({2.0, 0.0, 0.0, 0.0, 0.0});
  ticks[1].WasTaken = false;
  ticks[2].WasTaken = false;
  EXPECT_FALSE(StopProof::Of(ticks, Period).IsPassed());
  ticks[1].State = DeviceState::Error; // it is gone
  ticks[2].State = DeviceState::Error;
  EXPECT_TRUE(StopProof::Of(ticks, Period).IsPassed());
}

TEST(StopProof, CountsTorqueToo)
{
  std::vector<TouchState> ticks = TicksOf({2.0, 0.0, 0.0, 0.0});
  ticks[2].TorqueDevice.X = 1.0;
  EXPECT_FALSE(StopProof::Of(ticks, Period).IsPassed());
}

TEST(StopProof, FindsTheTickWhoseClutchOrFaultEndedAForce)
{
  std::vector<TouchState> ticks = TicksOf({0.0, 2.0, 2.0, 0.0});
  EXPECT_FALSE(StopProof::FindStop(ticks));
  ticks[0].Safety.Fault = SafetyFault::SwitchedOff; // before any force
  ticks[3].IsClutched = true;
  EXPECT_EQ(StopProof::FindStop(ticks), 3 * Period);
  ticks[2].Safety.Fault = SafetyFault::DeviceFailed;
  EXPECT_EQ(StopProof::FindStop(ticks), 2 * Period);
}
} // namespace
} // namespace palpate::stop_proof_test
