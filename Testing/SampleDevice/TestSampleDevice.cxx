#include "SampleDevice.h"

#include "DeviceContract.h"
#include "ManualClock.h"

namespace palpate::sample_device_test
{
namespace
{
// State of the other end of the wire.
struct Wire
{
  bool IsPluggedIn = true;
  int RepliesUntilHomed = 3;
  std::array<std::int16_t, 3> Counts{};
  std::array<std::int16_t, 3> Motors{};
};

class PortDouble final : public SamplePort
{
public:
  explicit PortDouble(Wire& wire) : OtherEnd(wire) {}
  bool Connect() override { return this->OtherEnd.IsPluggedIn; }
  void Disconnect() noexcept override {}
  bool Exchange(const std::array<std::int16_t, 3>& motors, Reply& reply) noexcept override
  {
    this->OtherEnd.Motors = motors;
    this->OtherEnd.RepliesUntilHomed -= this->OtherEnd.RepliesUntilHomed > 0 ? 1 : 0;
    reply = {this->OtherEnd.Counts, this->OtherEnd.RepliesUntilHomed == 0};
    return this->OtherEnd.IsPluggedIn;
  }

private:
  Wire& OtherEnd;
};

class SampleDeviceTest : public testing::Test
{
protected:
  DeviceSample ReadOnce()
  {
    DeviceSample sample;
    EXPECT_TRUE(this->Device.Read(sample));
    return sample;
  }

  Wire OtherEnd;
  ManualClock Time;
  SampleDevice Device{Time, std::make_unique<PortDouble>(OtherEnd)};
};

TEST_F(SampleDeviceTest, KeepsDeviceContract)
{
  test::ExpectDeviceContract(this->Device, [this] { this->Time.Advance(1'000'000); });
}

TEST_F(SampleDeviceTest, ConvertsCountsAndClampsForces)
{
  this->OtherEnd.RepliesUntilHomed = 0;
  this->OtherEnd.Counts = {100, -200, 0};
  ASSERT_TRUE(this->Device.Open().IsOk());
  EXPECT_EQ(Vector3(this->ReadOnce().Position), Vector3(5.0, -10.0, 0.0));
  EXPECT_TRUE(this->Device.Apply({1.0, -1000.0, 0.0}));
  this->ReadOnce();
  EXPECT_EQ(this->OtherEnd.Motors, (std::array<std::int16_t, 3>{500, -4095, 0}));
}

TEST_F(SampleDeviceTest, NoForceBeforeHoming)
{
  ASSERT_TRUE(this->Device.Open().IsOk());
  EXPECT_TRUE(this->Device.Apply({1.0, 1.0, 1.0}));
  this->ReadOnce();
  EXPECT_EQ(this->OtherEnd.Motors, (std::array<std::int16_t, 3>{}));
}

TEST_F(SampleDeviceTest, ReportsUnplugging)
{
  ASSERT_TRUE(this->Device.Open().IsOk());
  this->OtherEnd.IsPluggedIn = false;
  DeviceSample sample;
  EXPECT_FALSE(this->Device.Read(sample));
  EXPECT_EQ(this->Device.State(), DeviceState::Error);
  EXPECT_FALSE(this->Device.Problem().empty());
  this->Device.Close();
  EXPECT_EQ(this->Device.Open().Message(),
            "There is no sample device: plug it in and switch it on.");
}

TEST_F(SampleDeviceTest, CloseStopsMotors)
{
  this->OtherEnd.RepliesUntilHomed = 0;
  ASSERT_TRUE(this->Device.Open().IsOk());
  this->ReadOnce();
  EXPECT_TRUE(this->Device.Apply({1.0, 1.0, 1.0}));
  this->Device.Close();
  EXPECT_EQ(this->OtherEnd.Motors, (std::array<std::int16_t, 3>{}));
}
} // namespace
} // namespace palpate::sample_device_test
