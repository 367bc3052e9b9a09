// From a fault to 0 N at the board, over the real libusb and its thread, measured by the packets
// that the board received. It holds the last torque for ever, whatever happens to the cable.
#include "FalconOverUsb.h"

#include "Servo.h"
#include "TouchDoubles.h"

#include <algorithm>
#include <functional>
#include <string>

namespace palpate::stop_over_usb_test
{
namespace
{
using test::Eventually;
using test::FalconOverUsb;
using test::UsbfsFalcon;
using test::VirtualFalcon;
using test::VirtualFalconAnswer;

// A homed handle with a force on it.
class StopOverUsb : public FalconOverUsb
{
protected:
  void SetUp() override
  {
    ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
    ASSERT_TRUE(this->TickUntil([this] { return this->HasTorque(); }, Push));
  }

  std::size_t ReceivedCount()
  {
    return this->Bus.WithFalcon([](VirtualFalcon& falcon)
                                { return falcon.Board().Received().size(); });
  }
  // Number of packets since then that requested a torque.
  std::size_t TorquesSince(std::size_t first)
  {
    return this->Bus.WithFalcon(
        [first](VirtualFalcon& falcon)
        {
          const auto& received = falcon.Board().Received();
          return static_cast<std::size_t>(
              std::count_if(received.begin() + static_cast<std::ptrdiff_t>(first), received.end(),
                            [](const auto& order) { return order.HasTorque(); }));
        });
  }
  bool HasTorqueNow()
  {
    this->Bus.WithFalcon([this](VirtualFalcon& falcon) { falcon.NextDue(this->Time.Now()); });
    return this->HasTorque();
  }
  void ExpectStop(const char* fault, std::int64_t since)
  {
    EXPECT_TRUE(Eventually([this] { return !this->HasTorqueNow(); }));
    this->RecordProperty("front", "libusb");
    this->RecordProperty("fault", fault);
    this->RecordProperty("milliseconds", std::to_string(1e-6 * double(this->Time.Now() - since)));
    // Nothing that was queued follows it.
    const std::size_t stopped = this->ReceivedCount();
    this->Time.WaitUntil(this->Time.Now() + 5 * FalconLink::SilenceLimit);
    EXPECT_EQ(this->TorquesSince(stopped), 0U);
  }

  const Vector3 Push{0.0, 0.0, 3.0};
};

TEST_F(StopOverUsb, ZeroOvertakesQueue)
{
  const std::int64_t start = this->Time.Now();
  const std::size_t before = this->ReceivedCount();
  static_cast<void>(this->Device->Apply(Vector3::Zero()));
  this->ExpectStop("ZeroForce", start);
  // The capacity of an armed link.
  EXPECT_LE(this->TorquesSince(before), 4U);
}

TEST_F(StopOverUsb, ZeroDoesNotWaitForReplies)
{
  this->Bus.WithFalcon([](VirtualFalcon& falcon)
                       { falcon.Faults.Spoil = [](VirtualFalconAnswer& a) { a.Bytes.clear(); }; });
  bool isHeld = false;
  EXPECT_TRUE(this->TickUntil(
      [&]
      {
        isHeld = isHeld || !this->Device->Apply(this->Push);
        return isHeld;
      },
      this->Push));
  const std::int64_t start = this->Time.Now();
  EXPECT_TRUE(this->Device->Apply(Vector3::Zero()));
  this->ExpectStop("SwitchedOffWhileRepliesAreOwed", start);
}

TEST_F(StopOverUsb, ZeroIsFirstAfterFullQueue)
{
  this->Bus.HoldWrites(true);
  EXPECT_TRUE(this->TickUntil([this] { return !this->Device->Apply(this->Push); }, this->Push));
  // The bytes in the chip's buffer can't be taken back: 2 ms empty it ten times over.
  this->Time.WaitUntil(this->Time.Now() + 2'000'000);
  EXPECT_TRUE(this->HasTorqueNow());
  const std::size_t before = this->ReceivedCount();
  static_cast<void>(this->Device->Apply(Vector3::Zero()));
  // Earlier writes are cancelled; only the stop is waiting.
  EXPECT_TRUE(Eventually([this] { return this->Bus.WaitingWrites() == 1; }));
  const std::int64_t start = this->Time.Now();
  this->Bus.HoldWrites(false);
  this->ExpectStop("FullQueueFromWhenItMovesAgain", start);
  EXPECT_EQ(this->TorquesSince(before), 0U);
}

TEST_F(StopOverUsb, HangingServoLosesTorque)
{
  const std::int64_t start = this->Time.Now();
  this->ExpectStop("ServoHangs", start);
  EXPECT_GE(this->Time.Now() - start, FalconLink::SilenceLimit - 2'000'000);
}

TEST_F(StopOverUsb, SilentLinkStopsOnlyAFewTimes)
{
  const std::size_t before = this->ReceivedCount();
  EXPECT_TRUE(
      Eventually([&] { return this->ReceivedCount() >= before + FalconLink::StopRepeats; }));
  const std::size_t after = this->ReceivedCount();
  this->Time.WaitUntil(this->Time.Now() + 5 * FalconLink::SilenceLimit);
  EXPECT_LE(this->ReceivedCount(), after + 1);
}

TEST_F(StopOverUsb, StopsIfOnlyErrorsArrive)
{
  const std::int64_t start = this->Time.Now();
  this->Bus.FailReads(1'000'000);
  EXPECT_TRUE(
      this->TickUntil([this] { return this->Device->State() == DeviceState::Error; }, this->Push));
  this->ExpectStop("OnlyErrorsCome", start);
}

TEST_F(StopOverUsb, StopsOnceWritesRecover)
{
  for (const int failures : {1, 6})
  {
    const std::int64_t start = this->Time.Now();
    this->Bus.FailWrites(failures);
    EXPECT_TRUE(this->TickUntil([this] { return this->Device->State() == DeviceState::Error; },
                                this->Push));
    this->ExpectStop("WritesFail", start);
    this->Device->Close();
    ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
    ASSERT_TRUE(this->TickUntil([this] { return this->HasTorque(); }, this->Push));
  }
}

TEST_F(StopOverUsb, BlockedDeviceStopsOnceUnblocked)
{
  this->Bus.HoldWrites(true);
  EXPECT_TRUE(
      this->TickUntil([this] { return this->Device->State() == DeviceState::Error; }, this->Push));
  const std::size_t before = this->ReceivedCount();
  const std::int64_t start = this->Time.Now();
  this->Bus.HoldWrites(false);
  this->ExpectStop("TakesNothingFromWhenItDoesAgain", start);
  EXPECT_EQ(this->TorquesSince(before), 0U);
}

TEST_F(StopOverUsb, CloseStops)
{
  const std::int64_t start = this->Time.Now();
  this->Device->Close();
  this->ExpectStop("Closed", start);
}

TEST_F(StopOverUsb, HubResetKeepsTorqueUntilReopen)
{
  for (const auto how :
       {UsbfsFalcon::Unplugging::AbortsReads, UsbfsFalcon::Unplugging::RefusesNext})
  {
    ASSERT_TRUE(this->TickUntil([this] { return this->HasTorque(); }, this->Push));
    this->Bus.Unplug(how, VirtualFalcon::Supply::Kept);
    EXPECT_TRUE(this->TickUntil([this] { return this->Device->State() == DeviceState::Error; },
                                this->Push));
    EXPECT_TRUE(this->HasTorque()) << "the torque persists without a cable";
    const std::size_t before = this->ReceivedCount();
    this->Device->Close();
    this->Bus.Plug();
    ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
    EXPECT_EQ(this->TorquesSince(before), 0U);
  }
}

struct TouchStop
{
  std::string Name;
  std::function<void(VirtualFalcon&, Servo&, test::WallControl&)> Break;
};

void PrintTo(const TouchStop& c, std::ostream* stream)
{
  *stream << c.Name;
}

void Delay(VirtualFalcon& falcon, std::int64_t time)
{
  falcon.Faults.Spoil = [time](VirtualFalconAnswer& answer) { answer.Delay += time; };
}

const TouchStop TouchStops[] = {
    {"SwitchedOff", [](VirtualFalcon&, Servo& servo, test::WallControl&) { servo.SwitchOff(); }},
    {"RepliesStop", [](VirtualFalcon& falcon, Servo&, test::WallControl&)
     { falcon.Faults.Spoil = [](VirtualFalconAnswer& answer) { answer.Bytes.clear(); }; }},
    {"RepliesStall",
     [](VirtualFalcon& falcon, Servo&, test::WallControl&) { Delay(falcon, 1'000'000'000); }},
    {"RepliesComeLate",
     [](VirtualFalcon& falcon, Servo&, test::WallControl&) { Delay(falcon, 15'000'000); }},
    {"InvalidContact", [](VirtualFalcon&, Servo&, test::WallControl& wall)
     { wall.Fault = test::WallFault::Invalid; }},
    {"ForceIsNaN", [](VirtualFalcon&, Servo&, test::WallControl& wall)
     { wall.Fault = test::WallFault::NaNNormal; }},
    {"HomeIsLost",
     [](VirtualFalcon& falcon, Servo&, test::WallControl&)
     {
       falcon.Mechanism().Settings.CounterErrors = {};
       falcon.Mechanism().ForgetHome();
     }},
};

// A separate servo, which presses a wall that fills the workspace.
class TouchStopOverUsb : public StopOverUsb, public testing::WithParamInterface<TouchStop>
{
protected:
  // Ticks until a condition holds. Late ticks or samples are caused by other programs.
  template <typename Condition>
  bool Run(Servo& servo, Condition condition, bool rearms)
  {
    bool holds = false;
    FixedRateLoop(this->Time, 1'000'000)
        .Run(
            [&](const TickInfo& tick)
            {
              servo.Tick(tick);
              if (rearms && servo.Latest().Safety.Fault != SafetyFault::None)
              {
                servo.Rearm();
              }
              holds = condition();
              return !holds && tick.Number < 10'000;
            });
    return holds;
  }
};

TEST_P(TouchStopOverUsb, EndsInLastingZeroAtBoard)
{
  const auto wall = std::make_shared<test::WallControl>();
  Servo servo(*this->Device, ServoSettings());
  ASSERT_TRUE(
      servo.Publish(std::make_shared<TouchScene>(test::WallScene(90.0, {0.1, 0.0}, wall))).IsOk());
  ASSERT_TRUE(this->Run(
      servo,
      [&]
      {
        return servo.Latest().Safety.Fault == SafetyFault::None &&
               servo.Latest().ForceDevice.Z > 2.0 && this->HasTorque();
      },
      true));
  const std::int64_t start = this->Time.Now();
  this->Bus.WithFalcon([&](VirtualFalcon& falcon) { GetParam().Break(falcon, servo, *wall); });
  EXPECT_TRUE(this->Run(
      servo, [&] { return servo.Latest().Safety.Fault != SafetyFault::None; }, false));
  const std::int64_t fault = this->Time.Now();
  EXPECT_TRUE(this->Run(
      servo, [this] { return !this->HasTorqueNow(); }, false));
  this->RecordProperty("milliseconds_from_fault",
                       std::to_string(1e-6 * static_cast<double>(this->Time.Now() - fault)));
  this->ExpectStop(GetParam().Name.c_str(), start);
  const std::size_t stopped = this->ReceivedCount();
  EXPECT_TRUE(this->Run(
      servo, [&, n = 0]() mutable { return ++n == 300; }, false));
  EXPECT_EQ(this->TorquesSince(stopped), 0U);
}

INSTANTIATE_TEST_SUITE_P(All, TouchStopOverUsb, testing::ValuesIn(TouchStops),
                         [](const auto& chosen) { return chosen.param.Name; });
} // namespace
} // namespace palpate::stop_over_usb_test
