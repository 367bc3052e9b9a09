#include "FtdiRequest.h"
#include "VirtualFtdiChip.h"

#include <gtest/gtest.h>

#include <vector>

namespace palpate::test::virtual_ftdi_chip_test
{
namespace
{
constexpr std::int64_t Millisecond = 1'000'000; // ns

class VirtualFtdiChipTest : public testing::Test
{
protected:
  bool Ask(FtdiRequest request, std::int64_t now)
  {
    return this->Chip.ControlOut(request.Request, request.Value, request.Index, now);
  }
  std::size_t Take(std::int64_t now) { return this->Chip.TakePacket(this->Packet, now); }

  VirtualFtdiChip Chip;
  std::uint8_t Packet[64] = {};
};

TEST_F(VirtualFtdiChipTest, AcceptsRequestedRates)
{
  const auto rate = [this](FtdiRequest request)
  {
    EXPECT_TRUE(this->Ask(request, 0));
    return this->Chip.Baud();
  };
  EXPECT_DOUBLE_EQ(rate(FtdiRequest::Baud(312, 4)), 9600.0);
  EXPECT_DOUBLE_EQ(rate(FtdiRequest::Baud(2)), 1.5e6);
  for (unsigned eighths = 0; eighths < 8; ++eighths)
  {
    EXPECT_DOUBLE_EQ(rate(FtdiRequest::Baud(52, eighths)), 3e6 / (52.0 + eighths / 8.0));
  }
}

TEST_F(VirtualFtdiChipTest, SendsStatusAtEveryLatencyTimeout)
{
  ASSERT_TRUE(this->Ask(FtdiRequest::LatencyTimer(16), 0));
  EXPECT_EQ(this->Take(16 * Millisecond - 1), 0U);
  EXPECT_EQ(this->Take(16 * Millisecond), 2U);
  EXPECT_EQ(this->Take(16 * Millisecond), 0U);
  EXPECT_EQ(this->Chip.NextPacket(), 32 * Millisecond);
}

TEST_F(VirtualFtdiChipTest, FullPacketIsSentAtOnce)
{
  for (int i = 0; i < 70; ++i)
  {
    this->Chip.Receive({1000 + i, 9600.0, static_cast<std::uint8_t>(i)});
  }
  EXPECT_EQ(this->Take(1060), 0U);
  EXPECT_EQ(this->Take(1061), 64U);
  EXPECT_EQ(this->Packet[63], 61);
  EXPECT_EQ(this->Take(1061 + 16 * Millisecond), 10U);
}

TEST_F(VirtualFtdiChipTest, ReportsClearToSendChangeAtOnce)
{
  this->Chip.SetClearToSend(true, 5);
  EXPECT_EQ(this->Take(5), 2U);
  EXPECT_EQ(this->Packet[0] & 0x10, 0x10);
}

TEST_F(VirtualFtdiChipTest, MergesUnreadPackets)
{
  EXPECT_EQ(this->Take(1000 * Millisecond), 2U);
  EXPECT_EQ(this->Take(1000 * Millisecond), 0U);
}

TEST_F(VirtualFtdiChipTest, TransmitsAtBaudRate)
{
  ASSERT_TRUE(this->Ask(FtdiRequest::Baud(2), 0));
  const std::vector<std::uint8_t> bytes(3, 7);
  this->Chip.Transmit(bytes.data(), bytes.size(), 100);
  VirtualFtdiChip::WireByte byte{};
  // Ten bits at 1.5 MBd are 6,667 ns.
  EXPECT_FALSE(this->Chip.TakeTransmitted(100 + 6'666, byte));
  EXPECT_TRUE(this->Chip.TakeTransmitted(100 + 6'667, byte));
  EXPECT_EQ(this->Chip.NextTransmitted(), 100 + 2 * 6'667);
}

TEST_F(VirtualFtdiChipTest, WrongRateCorruptsBytes)
{
  ASSERT_TRUE(this->Ask(FtdiRequest::Baud(2), 0));
  this->Chip.Receive({10, 9600.0, 0x41});
  EXPECT_EQ(this->Take(16 * Millisecond), 3U);
  EXPECT_NE(this->Packet[2], 0x41);
  EXPECT_EQ(this->Packet[1] & 0x08, 0x08);
}

TEST_F(VirtualFtdiChipTest, PurgesOneDirection)
{
  const std::uint8_t byte = 1;
  this->Chip.Transmit(&byte, 1, 0);
  this->Chip.Receive({0, 9600.0, 1});
  ASSERT_TRUE(this->Ask(FtdiRequest::PurgeIn(), 0));
  EXPECT_NE(this->Chip.NextTransmitted(), VirtualFtdiChip::Never);
  EXPECT_EQ(this->Take(16 * Millisecond), 2U);
  ASSERT_TRUE(this->Ask(FtdiRequest::PurgeOut(), 0));
  EXPECT_EQ(this->Chip.NextTransmitted(), VirtualFtdiChip::Never);
}
} // namespace
} // namespace palpate::test::virtual_ftdi_chip_test
