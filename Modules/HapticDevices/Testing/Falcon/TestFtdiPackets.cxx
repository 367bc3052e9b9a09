#include "FtdiPackets.h"
#include "FtdiRequest.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace palpate::ftdi_packets_test
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

Bytes Stripped(FtdiPackets& packets, Bytes transfer)
{
  // In place, the harder case.
  transfer.resize(packets.Strip(transfer.data(), transfer.size(), transfer.data()));
  return transfer;
}

TEST(FtdiPackets, StripsStatusOfEveryPacket)
{
  std::mt19937_64 random(5);
  for (int round = 0; round < 500; ++round)
  {
    FtdiPackets packets;
    const std::size_t count = random() % 300;
    Bytes payload;
    Bytes transfer;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (i % (FtdiPackets::PacketSize - FtdiPackets::StatusSize) == 0)
      {
        transfer.insert(transfer.end(), {0x01, 0x60});
      }
      payload.push_back(static_cast<std::uint8_t>(random()));
      transfer.push_back(payload.back());
    }
    ASSERT_EQ(Stripped(packets, transfer), payload) << count;
  }
}

TEST(FtdiPackets, StatusOnlyPacketUpdatesClearToSend)
{
  FtdiPackets packets;
  EXPECT_FALSE(packets.ClearToSend());
  EXPECT_TRUE(Stripped(packets, {0x11, 0x60}).empty());
  EXPECT_TRUE(packets.ClearToSend());
  EXPECT_EQ(Stripped(packets, {0x01, 0x60, 0x3C}), Bytes{0x3C});
  EXPECT_FALSE(packets.ClearToSend());
}

TEST(FtdiPackets, IgnoresStatusFragments)
{
  FtdiPackets packets;
  EXPECT_TRUE(Stripped(packets, {}).empty());
  EXPECT_TRUE(Stripped(packets, {0x11}).empty());
  EXPECT_FALSE(packets.ClearToSend());
}

// The values known to work with a Falcon.
TEST(FtdiRequest, DivisorsMatchKnownValues)
{
  EXPECT_EQ(FtdiRequest::Baud(312, 4).Value, 0x4138); // 9600 Bd
  EXPECT_EQ(FtdiRequest::Baud(21).Value, 0x0015);     // 142,857 Bd
  EXPECT_EQ(FtdiRequest::Baud(2).Value, 0x0002);      // 1.5 MBd
  EXPECT_EQ(FtdiRequest::Baud(312, 4).Index, 0);
  EXPECT_EQ(FtdiRequest::Baud(2, 3).Index, 1); // the third bit of the fraction's code
  EXPECT_EQ(FtdiRequest::Baud(2, 3).Value, 0x0002);
}
} // namespace
} // namespace palpate::ftdi_packets_test
