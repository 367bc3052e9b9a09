#include "FalconDevice.h"

#include "AllocationCounter.h"
#include "BootStream.h"
#include "DeviceContract.h"
#include "ManualClock.h"
#include "RandomShapes.h"
#include "TemporaryFolder.h"
#include "VirtualFalconLink.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace palpate::falcon_device_test
{
namespace
{
using test::VirtualFalconAnswer;

constexpr std::int64_t Period = 1'000'000; // ns
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
const Vector3 Center(0.0, 0.0, 125.0); // mm

// A driver with a virtual Falcon on its cable. The hand is rigid and first pulls the handle out and
// pushes it in; then the test sets its position.
class FalconDeviceTest : public testing::Test
{
protected:
  FalconDeviceTest() : FalconDeviceTest(FalconSettings()) {}
  explicit FalconDeviceTest(FalconSettings settings)
  {
    this->Mechanism().Settings.IsRigid = true;
    this->Mechanism().Settings.CountsPerNewtonMillimeter = 6.6;
    this->Mechanism().Settings.Path = [this](double t) { return this->HandAt(t); };
    const auto image = test::BootStream();
    settings.FirmwarePath = (this->Folder / "firmware.bin").string();
    test::WriteAll(settings.FirmwarePath, {image.begin(), image.end()});
    auto link = std::make_unique<test::VirtualFalconLink>(this->Falcon, this->Time);
    this->Cable = link.get();
    this->Device = std::make_unique<FalconDevice>(this->Time, std::move(link), std::move(settings));
  }

  test::VirtualMechanism& Mechanism() { return this->Falcon.Mechanism(); }

  Vector3 HandAt(double t) const
  {
    if (!this->IsPulling)
    {
      return this->Hand;
    }
    // Twice a second from 85 to 175 mm and back.
    return {0.0, 0.0, 130.0 - 45.0 * std::cos(4.0 * M_PI * t)};
  }

  // One servo cycle that applies this force; false if the device failed.
  bool Tick(const Vector3& force = Vector3::Zero())
  {
    this->Time.Advance(Period);
    const bool isRead = this->Device->Read(this->Sample);
    static_cast<void>(this->Device->Apply(force)); // may be held
    return isRead && this->Device->State() != DeviceState::Error;
  }

  void OpenAndHome()
  {
    const Status status = this->Device->Open();
    ASSERT_TRUE(status.IsOk()) << status.Message();
    for (int n = 0; n < 3000 && this->Device->State() != DeviceState::Ready; ++n)
    {
      ASSERT_TRUE(this->Tick());
    }
    ASSERT_EQ(this->Device->State(), DeviceState::Ready);
    this->GoTo(Vector3::Zero());
  }

  // Moves the hand there (mm from the workspace's centre) and waits for a few replies.
  void GoTo(const Vector3& position, const Vector3& force = Vector3::Zero())
  {
    this->IsPulling = false;
    this->Hand = Center + position;
    for (int n = 0; n < 8; ++n)
    {
      ASSERT_TRUE(this->Tick(force));
    }
  }

  bool MotorsAreOff() const
  {
    return this->Falcon.Board().Motors() == std::array<std::int16_t, 3>{};
  }

  test::TemporaryFolder Folder;
  ManualClock Time{1'000'000'000};
  test::VirtualFalcon Falcon;
  test::VirtualFalconLink* Cable = nullptr;
  std::unique_ptr<FalconDevice> Device;
  DeviceSample Sample;
  Vector3 Hand = Center;
  bool IsPulling = true;
};

TEST_F(FalconDeviceTest, KeepsDeviceContract)
{
  test::ExpectDeviceContract(*this->Device, [this] { this->Time.Advance(Period); });
}

TEST_F(FalconDeviceTest, PositionsMatchHandWithinACount)
{
  this->OpenAndHome();
  test::Random random(81);
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 position = 40.0 * std::cbrt(static_cast<double>(random() % 1000) / 1000.0) *
                             test::RandomDirection(random);
    this->GoTo(position);
    // Half a count of each leg; a count of one moves the grip by up to 0.06 mm at the edges.
    ASSERT_LT((Vector3(this->Sample.Position) - position).norm(), 0.06);
  }
}

TEST_F(FalconDeviceTest, RendersForceWithSizeAndDirection)
{
  this->OpenAndHome();
  test::Random random(82);
  double worstSize = 0.0;
  double worstAngle = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 position = 40.0 * std::cbrt(static_cast<double>(random() % 1000) / 1000.0) *
                             test::RandomDirection(random);
    const double size = 1.0 + (this->Device->Capabilities().MaximumForce - 1.0) *
                                  static_cast<double>(random() % 1000) / 1000.0;
    const Vector3 force = size * test::RandomDirection(random);
    this->GoTo(position, force);
    const Vector3 felt = this->Mechanism().MotorForce();
    worstSize = std::max(worstSize, std::abs(felt.norm() / size - 1.0));
    worstAngle = std::max(worstAngle, std::atan2(felt.cross(force).norm(), felt.dot(force)));
  }
  // Motor values are integers: half of one in some hundred at 1 N.
  EXPECT_LE(worstSize, 0.02);
  EXPECT_LE(worstAngle, 1.0 * M_PI / 180.0);
  this->RecordProperty("worst_size_percent", std::to_string(100.0 * worstSize));
  this->RecordProperty("worst_angle_degrees", std::to_string(worstAngle * 180.0 / M_PI));
}

TEST_F(FalconDeviceTest, SaturatedForceKeepsDirection)
{
  this->OpenAndHome();
  test::Random random(83);
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 position = 40.0 * std::cbrt(static_cast<double>(random() % 1000) / 1000.0) *
                             test::RandomDirection(random);
    const Vector3 force = 1000.0 * test::RandomDirection(random);
    this->GoTo(position, force);
    const Vector3 felt = this->Mechanism().MotorForce();
    ASSERT_LE(std::atan2(felt.cross(force).norm(), felt.dot(force)), 1.0 * M_PI / 180.0);
    // The promised force is available in any direction; the sampled corner points miss the worst
    // place by a few percent.
    ASSERT_GE(felt.norm(), 0.95 * this->Device->Capabilities().MaximumForce);
  }
}

TEST_F(FalconDeviceTest, NoForceBeforeHoming)
{
  this->IsPulling = false;
  ASSERT_TRUE(this->Device->Open().IsOk());
  for (int n = 0; n < 500; ++n)
  {
    ASSERT_TRUE(this->Tick({3.0, 3.0, 3.0}));
    ASSERT_EQ(this->Device->State(), DeviceState::Homing);
    ASSERT_TRUE(this->MotorsAreOff());
    ASSERT_EQ(this->Falcon.Board().Flags(), 1U + 8U) << "homing, red";
  }
  this->IsPulling = true;
  for (int n = 0; n < 2000 && this->Device->State() != DeviceState::Ready; ++n)
  {
    ASSERT_TRUE(this->MotorsAreOff());
    ASSERT_TRUE(this->Tick({3.0, 3.0, 3.0}));
  }
  ASSERT_TRUE(this->Tick({3.0, 3.0, 3.0}));
  this->Time.Advance(Period);
  ASSERT_TRUE(this->Device->Read(this->Sample));
  EXPECT_FALSE(this->MotorsAreOff());
  EXPECT_EQ(this->Falcon.Board().Flags(), 1U + 2U) << "homing, green";
}

TEST_F(FalconDeviceTest, HomedDeviceIsReadyOnReopen)
{
  this->OpenAndHome();
  this->Device->Close();
  const int resets = this->Falcon.Board().Resets();
  ASSERT_TRUE(this->Device->Open().IsOk());
  EXPECT_EQ(this->Falcon.Board().Resets(), resets);
  for (int n = 0; n < 40; ++n)
  {
    ASSERT_TRUE(this->Tick());
  }
  EXPECT_EQ(this->Device->State(), DeviceState::Ready);
}

TEST_F(FalconDeviceTest, UnpluggingInContactIsErrorWithinTwoTicks)
{
  this->OpenAndHome();
  for (int n = 0; n < 5; ++n)
  {
    ASSERT_TRUE(this->Tick({0.0, 0.0, 5.0}));
  }
  ASSERT_FALSE(this->MotorsAreOff());
  this->Falcon.Unplug(this->Time.Now());
  EXPECT_FALSE(this->Device->Read(this->Sample)) << "must not wait for a force";
  EXPECT_EQ(this->Device->State(), DeviceState::Error);
  EXPECT_EQ(this->Device->Problem(), "The Falcon was unplugged: plug it in and open it again.");
  EXPECT_FALSE(this->Device->Apply({0.0, 0.0, 5.0}));
  EXPECT_EQ(this->Mechanism().MotorForce(), Vector3::Zero());

  this->Device->Close();
  EXPECT_EQ(this->Device->Open().Message(), "There is no Falcon: plug it in and switch it on.");
  this->Falcon.Plug(this->Time.Now());
  this->IsPulling = true;
  this->OpenAndHome();
}

TEST_F(FalconDeviceTest, UnpluggingAtAnyReplyEndsWithoutForce)
{
  for (std::uint64_t reply = 30; reply < 90; ++reply)
  {
    this->IsPulling = true;
    ASSERT_TRUE(this->Device->Open().IsOk());
    this->Falcon.Faults.UnplugAtReply = reply;
    for (int n = 0; n < 200; ++n)
    {
      this->Tick({0.0, 0.0, 5.0});
    }
    ASSERT_EQ(this->Device->State(), DeviceState::Error) << reply;
    ASSERT_TRUE(this->MotorsAreOff());
    this->Device->Close();
    this->Falcon.Faults.UnplugAtReply = 0;
    this->Falcon.Plug(this->Time.Now());
  }
}

TEST_F(FalconDeviceTest, SilentDeviceGetsNoForceAndErrors)
{
  this->OpenAndHome();
  ASSERT_TRUE(this->Tick({0.0, 0.0, 5.0}));
  this->Falcon.Faults.Spoil = [](VirtualFalconAnswer& answer) { answer.Bytes.clear(); };
  int ticks = 0;
  while (this->Tick({0.0, 0.0, 5.0}) && ticks < 1000)
  {
    ++ticks;
    if (ticks > 35)
    {
      // Positions are too old after 20 ms; the next request is up to 8 ms later.
      ASSERT_TRUE(this->MotorsAreOff()) << ticks;
    }
  }
  EXPECT_NEAR(ticks, 200, 5);
  EXPECT_EQ(this->Device->Problem(),
            "The Falcon does not answer any more: check its power supply and its cable, then open "
            "it again.");
}

TEST_F(FalconDeviceTest, SurvivesLateOrPausedServo)
{
  ASSERT_TRUE(this->Device->Open().IsOk());
  for (int pause = 0; pause < 3; ++pause)
  {
    // Also if the last replies before a pause were lost.
    this->Falcon.Faults.Spoil = [](VirtualFalconAnswer& answer) { answer.Bytes.clear(); };
    this->Time.Advance(20 * Period);
    ASSERT_TRUE(this->Tick());
    this->Time.Advance(5'000 * Period);
    this->Falcon.Faults.Spoil = nullptr;
    for (int n = 0; n < 20; ++n)
    {
      ASSERT_TRUE(this->Tick()) << this->Device->Problem();
    }
  }
}

TEST_F(FalconDeviceTest, LostHomingIsError)
{
  this->OpenAndHome();
  ASSERT_TRUE(this->Tick({0.0, 0.0, 5.0}));
  // The counts stay right, so that only the missing bits reveal it.
  this->Mechanism().Settings.CounterErrors = {};
  this->Mechanism().ForgetHome();
  for (int n = 0; n < 10; ++n)
  {
    this->Tick({0.0, 0.0, 5.0});
  }
  EXPECT_EQ(this->Device->State(), DeviceState::Error);
  this->Time.Advance(Period);
  this->Falcon.NextDue(this->Time.Now());
  EXPECT_TRUE(this->MotorsAreOff());
  EXPECT_EQ(this->Device->Problem(), "The Falcon's encoders lost their zero: open it again and "
                                     "pull the handle out and push it in.");
}

TEST_F(FalconDeviceTest, WireFaultsNeverMovePosition)
{
  this->OpenAndHome();
  this->Mechanism().Settings.Path = [this](double t) -> Vector3
  { return this->Hand + Vector3(15.0 * std::sin(9.0 * t), 12.0 * std::sin(7.0 * t), 0.0); };
  for (int n = 0; n < 5; ++n)
  {
    ASSERT_TRUE(this->Tick());
  }
  // By value: the device is closed after this function has returned.
  this->Falcon.Faults.Spoil = [random = test::Random(84)](VirtualFalconAnswer& answer) mutable
  {
    const auto at = static_cast<std::ptrdiff_t>(random() % answer.Bytes.size());
    const auto once = answer.Bytes;
    switch (random() % 40)
    {
    case 0:
      answer.Bytes.clear();
      break;
    case 1:
      answer.Bytes.erase(answer.Bytes.begin() + at);
      break;
    case 2:
      answer.Bytes[static_cast<std::size_t>(at)] ^= static_cast<std::uint8_t>(1U << random() % 8);
      break;
    case 3:
      answer.Bytes.insert(answer.Bytes.end(), once.begin(), once.end());
      break;
    case 4:
      answer.Delay += static_cast<std::int64_t>(random() % 6'000'000);
      break;
    default:
      break;
    }
  };
  for (int n = 0; n < 20000; ++n)
  {
    const Vector3 before = this->Sample.Position;
    ASSERT_TRUE(this->Tick({1.0, 0.0, 0.0}));
    ASSERT_EQ(this->Device->State(), DeviceState::Ready);
    const Vector3 hand = this->Mechanism().Position() - Center;
    // 0.16 m/s for up to ten milliseconds; a changed nibble of 12 counts, 0.7 mm.
    ASSERT_LT((Vector3(this->Sample.Position) - hand).norm(), 1.6 + 0.7) << n;
    ASSERT_LT((Vector3(this->Sample.Position) - before).norm(), 1.6 + 0.7) << n;
  }
  const FalconStatistics statistics = this->Device->Statistics();
  EXPECT_GT(statistics.Lost, 500U);
  // Most of 500 changed bits break the form of a reply.
  EXPECT_GT(statistics.Implausible, 40U);
  EXPECT_GT(statistics.SkippedBytes, 1000U);
}

TEST_F(FalconDeviceTest, InvalidCountsBlockForceUntilZeroRequest)
{
  this->OpenAndHome();
  ASSERT_TRUE(this->Tick({0.0, 0.0, 5.0}));
  // All thighs beyond their limits.
  this->Falcon.Faults.Spoil = [](VirtualFalconAnswer& answer)
  {
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      answer.Bytes[4 + 4 * leg] = 'B';
    }
  };
  for (int n = 0; n < 5; ++n)
  {
    ASSERT_TRUE(this->Tick({0.0, 0.0, 5.0}));
  }
  const DeviceSample last = this->Sample;
  for (int n = 0; n < 50; ++n)
  {
    ASSERT_TRUE(this->Tick({0.0, 0.0, 5.0}));
    ASSERT_TRUE(this->MotorsAreOff());
    ASSERT_EQ(this->Sample.Sequence, last.Sequence);
  }
  this->Falcon.Faults.Spoil = nullptr;
  this->GoTo({5.0, 0.0, 0.0}, {0.0, 0.0, 5.0});
  EXPECT_NEAR(this->Sample.Position.X, 5.0, 0.06);
  EXPECT_TRUE(this->MotorsAreOff());
  EXPECT_FALSE(this->Device->Apply({0.0, 0.0, 5.0}));
  ASSERT_TRUE(this->Tick(Vector3::Zero()));
  this->GoTo({5.0, 0.0, 0.0}, {0.0, 0.0, 5.0});
  EXPECT_FALSE(this->MotorsAreOff());
}

TEST_F(FalconDeviceTest, NanForceIsZero)
{
  this->OpenAndHome();
  this->GoTo(Vector3::Zero(), {NaN, 1.0, 1.0});
  EXPECT_TRUE(this->MotorsAreOff());
  this->GoTo(Vector3::Zero(), {0.0, std::numeric_limits<double>::infinity(), 1.0});
  EXPECT_TRUE(this->MotorsAreOff());
}

TEST_F(FalconDeviceTest, CloseStopsMotorsFirst)
{
  this->OpenAndHome();
  this->GoTo(Vector3::Zero(), {0.0, 0.0, 5.0});
  ASSERT_FALSE(this->MotorsAreOff());
  this->Device->Close();
  EXPECT_TRUE(this->MotorsAreOff());
  EXPECT_EQ(this->Mechanism().MotorForce(), Vector3::Zero());
}

TEST_F(FalconDeviceTest, ButtonsIgnoreSingleWrongByte)
{
  this->OpenAndHome();
  for (unsigned buttons = 0; buttons < 16; ++buttons)
  {
    this->Mechanism().Settings.Buttons = buttons;
    this->GoTo(Vector3::Zero());
    EXPECT_EQ(this->Sample.Buttons, buttons);
  }
  this->Mechanism().Settings.Buttons = 0;
  this->GoTo(Vector3::Zero());
  this->Falcon.Faults.Spoil = [](VirtualFalconAnswer& answer)
  { answer.Bytes[13] ^= answer.Number % 5 == 0 ? 2U : 0U; };
  for (int n = 0; n < 50; ++n)
  {
    ASSERT_TRUE(this->Tick());
    ASSERT_EQ(this->Sample.Buttons, 0U);
  }
}

TEST_F(FalconDeviceTest, StaysClosedIfOpenFails)
{
  this->Cable->IsBusy = true;
  EXPECT_EQ(this->Device->Open().Message(), "Another program uses the Falcon: end it.");
  EXPECT_EQ(this->Device->State(), DeviceState::Closed);
  this->Cable->IsBusy = false;
  this->Falcon.Faults.HasSupply = false;
  EXPECT_FALSE(this->Device->Open().IsOk());
  EXPECT_EQ(this->Device->State(), DeviceState::Closed);
}

// A homed Falcon at count 0 that answers at once, without allocating.
class InstantLink final : public FalconLink
{
public:
  Status Open() override { return Status::Success(); }
  void Close() noexcept override {}
  Status Control(FtdiRequest) override { return Status::Success(); }
  bool Send(const std::uint8_t*, std::size_t) noexcept override
  {
    ++this->Owed;
    return true;
  }
  void ArmStop(const std::uint8_t*, std::size_t) noexcept override {}
  bool SendStop() noexcept override { return this->Send(nullptr, FalconPacketSize); }
  std::size_t Receive(std::uint8_t* bytes, std::size_t capacity) noexcept override
  {
    constexpr char reply[] = "<AAAAAAAAAAAA\xB1"
                             "A>";
    std::size_t count = 0;
    for (; count<capacity&& this->Owed> 0; ++count)
    {
      bytes[count] = static_cast<std::uint8_t>(reply[this->Place]);
      this->Place = (this->Place + 1) % FalconPacketSize;
      this->Owed -= this->Place == 0 ? 1 : 0;
    }
    return count;
  }
  bool ClearToSend() const noexcept override { return true; }
  bool IsGone() const noexcept override { return false; }

private:
  int Owed = 0;
  std::size_t Place = 0;
};

// The servo adds the weight to the forces before its safety chain.
TEST(FalconDevice, CarriedMassIsCapabilityNotTorque)
{
  ManualClock time;
  FalconSettings settings;
  settings.Calibration.CarriedMass = 0.1;
  const FalconDevice device(time, std::make_unique<InstantLink>(), settings);
  EXPECT_EQ(Vector3(device.Capabilities().GravityCompensation), Vector3(0.0, 9.81 * 0.1, 0.0));
}

TEST(FalconDevice, TickDoesNotAllocate)
{
  ManualClock time;
  FalconDevice device(time, std::make_unique<InstantLink>(), {});
  ASSERT_TRUE(device.Open().IsOk());
  DeviceSample sample;
  const std::size_t before = test::AllocationCount();
  bool isFine = true;
  for (int n = 0; n < 200; ++n)
  {
    time.Advance(Period);
    isFine = device.Read(sample) && device.Apply({1.0, 2.0, 3.0}) && isFine;
  }
  EXPECT_EQ(test::AllocationCount(), before);
  EXPECT_TRUE(isFine);
  EXPECT_EQ(device.State(), DeviceState::Ready);
}
} // namespace
} // namespace palpate::falcon_device_test
