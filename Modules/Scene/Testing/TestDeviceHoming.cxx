#include "DeviceHoming.h"

#include "InputError.h"
#include "SimulatedDevice.h"
#include "SteadyClock.h"

#include <gtest/gtest.h>

namespace palpate::device_homing_test
{
namespace
{
class DeviceHomingTest : public testing::Test
{
protected:
  void OpenHoming(double seconds)
  {
    SimulatedSettings settings;
    settings.HomingDuration = seconds;
    this->Device = std::make_unique<SimulatedDevice>(this->Time, settings);
    ASSERT_TRUE(this->Device->Open().IsOk());
  }

  SteadyClock Time;
  std::unique_ptr<SimulatedDevice> Device;
};

TEST_F(DeviceHomingTest, EndsWhenHomedAndCountsTicks)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenHoming(0.2));
  int homing = 0;
  const HomingReport report = HomeDevice(*this->Device, 0.0,
                                         [&](const HomingView& view)
                                         {
                                           homing += view.State == DeviceState::Homing ? 1 : 0;
                                           return true;
                                         });
  EXPECT_EQ(report.State, DeviceState::Ready);
  EXPECT_GE(report.HomedAfter, 0.2);
  EXPECT_GT(homing, 0);
  // One sample per tick, and one period less.
  EXPECT_EQ(report.Periods.Count() + 1, report.Ticks);
  EXPECT_EQ(this->Device->Hand().Position(), Vector3(Vector3::Zero())) << "no force is applied";
}

TEST_F(DeviceHomingTest, RunsForTheRequestedTime)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenHoming(0.0));
  EXPECT_GE(HomeDevice(*this->Device, 0.2, [](const HomingView&) { return true; }).Seconds, 0.2);
}

TEST_F(DeviceHomingTest, StopsOnRequest)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenHoming(1000.0));
  int looks = 0;
  const HomingReport report =
      HomeDevice(*this->Device, 0.0, [&](const HomingView&) { return ++looks < 3; });
  EXPECT_EQ(report.State, DeviceState::Homing);
  EXPECT_EQ(report.HomedAfter, 0.0);
  EXPECT_EQ(looks, 3);
}

TEST_F(DeviceHomingTest, DeviceFailureEndsHomingWithItsMessage)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenHoming(1000.0));
  const HomingReport report = HomeDevice(*this->Device, 0.0,
                                         [&](const HomingView& view)
                                         {
                                           this->Device->Inject(SimulatedFault::Unplugged);
                                           return view.State == DeviceState::Homing;
                                         });
  EXPECT_EQ(report.State, DeviceState::Error);
  EXPECT_EQ(report.Problem, "The simulated device was unplugged.");
}

TEST_F(DeviceHomingTest, HomesWithoutAcceptedForces)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenHoming(0.1));
  this->Device->Inject(SimulatedFault::RefusedForce);
  constexpr double LongEnough = 30.0; // s
  const HomingReport report = HomeDevice(
      *this->Device, 0.0, [](const HomingView& view) { return view.Seconds < LongEnough; });
  EXPECT_EQ(report.State, DeviceState::Ready);
}

TEST_F(DeviceHomingTest, RejectsUnknownKind)
{
  EXPECT_THROW(HomeDevice("phantom", 0.0, [](const HomingView&) { return true; }), InputError);
}
} // namespace
} // namespace palpate::device_homing_test
