// From a fault to 0 N at the board, over the real libusb and its thread, by the packets that the
// board received. It holds the last torque for ever, whatever becomes of the cable.
#include "FalconOverUsb.h"

#include "Servo.h"
#include "TouchDoubles.h"

#include <algorithm>

namespace palpate
{
namespace
{
using test::Eventually;
using test::FalconOverUsb;
using test::UsbfsFalcon;
using test::VirtualFalcon;
using test::VirtualFalconAnswer;

// A handle that was homed and a force on it.
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
  // Of the packets that came since, those that asked for a torque.
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
  }

  const Vector3 Push{0.0, 0.0, 3.0};
};

TEST_F(StopOverUsb, ZeroOvertakesWhatIsQueued)
{
  const std::int64_t start = this->Time.Now();
  const std::size_t before = this->ReceivedCount();
  static_cast<void>(this->Device->Apply(Vector3::Zero()));
  this->ExpectStop("switched off", start);
  // What an armed link holds at most.
  EXPECT_LE(this->TorquesSince(before), 4U);
}

TEST_F(StopOverUsb, ZeroGoesOutThoughRepliesAreOwed)
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
  this->ExpectStop("switched off while replies are owed", start);
}

TEST_F(StopOverUsb, ZeroIsFirstWhereAFullQueueMovesAgain)
{
  this->Bus.HoldWrites(true);
  EXPECT_TRUE(this->TickUntil([this] { return !this->Device->Apply(this->Push); }, this->Push));
  const std::size_t before = this->ReceivedCount();
  static_cast<void>(this->Device->Apply(Vector3::Zero()));
  // The writes before it are taken back; the stop alone waits.
  EXPECT_TRUE(Eventually([this] { return this->Bus.WaitingWrites() == 1; }));
  const std::int64_t start = this->Time.Now();
  this->Bus.HoldWrites(false);
  this->ExpectStop("full queue, from when it moves again", start);
  EXPECT_EQ(this->TorquesSince(before), 0U);
}

TEST_F(StopOverUsb, AServoThatHangsLosesItsTorque)
{
  const std::int64_t start = this->Time.Now();
  this->ExpectStop("servo hangs", start);
  EXPECT_GE(this->Time.Now() - start, FalconLink::SilenceLimit - 2'000'000);
}

TEST_F(StopOverUsb, ASilentLinkStopsAFewTimesAndThenLeavesTheDeviceAlone)
{
  const std::size_t before = this->ReceivedCount();
  EXPECT_TRUE(
      Eventually([&] { return this->ReceivedCount() >= before + FalconLink::StopRepeats; }));
  const std::size_t after = this->ReceivedCount();
  this->Time.WaitUntil(this->Time.Now() + 5 * FalconLink::SilenceLimit);
  EXPECT_LE(this->ReceivedCount(), after + 1);
}

TEST_F(StopOverUsb, WhereOnlyErrorsComeItStops)
{
  const std::int64_t start = this->Time.Now();
  this->Bus.FailReads(1'000'000);
  EXPECT_TRUE(
      this->TickUntil([this] { return this->Device->State() == DeviceState::Error; }, this->Push));
  this->ExpectStop("only errors come", start);
}

TEST_F(StopOverUsb, ADeviceThatTakesNothingFailsAndStopsOnceItTakesAgain)
{
  this->Bus.HoldWrites(true);
  EXPECT_TRUE(
      this->TickUntil([this] { return this->Device->State() == DeviceState::Error; }, this->Push));
  const std::size_t before = this->ReceivedCount();
  const std::int64_t start = this->Time.Now();
  this->Bus.HoldWrites(false);
  this->ExpectStop("takes nothing until the driver gives up, from when it does again", start);
  EXPECT_EQ(this->TorquesSince(before), 0U);
}

TEST_F(StopOverUsb, ClosingStops)
{
  const std::int64_t start = this->Time.Now();
  this->Device->Close();
  this->ExpectStop("closed", start);
}

TEST_F(StopOverUsb, AHubThatResetsLeavesTheTorqueUntilTheDeviceIsOpenedAgain)
{
  for (const auto how :
       {UsbfsFalcon::Unplugging::AbortsReads, UsbfsFalcon::Unplugging::RefusesNext})
  {
    ASSERT_TRUE(this->TickUntil([this] { return this->HasTorque(); }, this->Push));
    this->Bus.Unplug(how, VirtualFalcon::Supply::Kept);
    EXPECT_TRUE(this->TickUntil([this] { return this->Device->State() == DeviceState::Error; },
                                this->Push));
    EXPECT_TRUE(this->HasTorque()) << "what remains without a cable";
    const std::size_t before = this->ReceivedCount();
    this->Device->Close();
    this->Bus.Plug();
    ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
    EXPECT_EQ(this->TorquesSince(before), 0U);
  }
}

TEST_F(StopOverUsb, ATouchThatIsSwitchedOffEndsInZeroAtTheBoard)
{
  Servo servo(*this->Device, ServoSettings());
  // All of the workspace is inside of this wall.
  ASSERT_TRUE(
      servo.Publish(std::make_shared<TouchScene>(test::WallScene(40.0, {0.2, 0.0}))).IsOk());
  const auto run = [&](const auto& condition)
  {
    bool holds = false;
    FixedRateLoop(this->Time, 1'000'000)
        .Run(
            [&](const TickInfo& tick)
            {
              servo.Tick(tick);
              if (servo.Latest().Safety.Fault == SafetyFault::StalledTick ||
                  servo.Latest().Safety.Fault == SafetyFault::StaleSample)
              {
                servo.Rearm(); // another program's doing
              }
              holds = condition();
              return !holds && tick.Number < 10'000;
            });
    return holds;
  };
  ASSERT_TRUE(run([this, &servo] { return servo.Latest().Safety.IsArmed && this->HasTorque(); }));
  const std::int64_t start = this->Time.Now();
  servo.SwitchOff();
  EXPECT_TRUE(run([this] { return !this->HasTorqueNow(); }));
  EXPECT_EQ(servo.Latest().Safety.Fault, SafetyFault::SwitchedOff);
  this->ExpectStop("switched off in a touch", start);
}
} // namespace
} // namespace palpate
