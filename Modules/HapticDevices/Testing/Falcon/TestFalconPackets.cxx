#include "FalconPackets.h"
#include "FalconReplyParser.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <vector>

namespace palpate::falcon_packets_test
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

std::string TextOf(const FalconRequest& request)
{
  const FalconPacket packet = Encoded(request);
  return {packet.begin(), packet.end()};
}

// The format is the same both ways, except for the flags and a byte of unknown meaning.
FalconPacket ReplyPacket(const FalconReply& reply, std::uint8_t unknown = 0x41)
{
  FalconRequest request;
  request.Motors = reply.Counts;
  FalconPacket packet = Encoded(request);
  packet[13] = static_cast<std::uint8_t>(0x41 + (reply.Homed << 4U) + reply.Buttons);
  packet[14] = unknown;
  return packet;
}

FalconReply RandomReply(std::mt19937_64& random)
{
  FalconReply reply;
  for (std::int16_t& count : reply.Counts)
  {
    count = static_cast<std::int16_t>(static_cast<std::uint16_t>(random()));
  }
  reply.Homed = random() % 8;
  reply.Buttons = random() % 16;
  return reply;
}

bool AreEqual(const FalconReply& a, const FalconReply& b)
{
  return a.Counts == b.Counts && a.Homed == b.Homed && a.Buttons == b.Buttons;
}

std::vector<FalconReply> Parsed(const Bytes& stream, FalconReplyParser& parser)
{
  std::vector<FalconReply> replies;
  for (const std::uint8_t byte : stream)
  {
    FalconReply reply;
    if (parser.Take(byte, reply))
    {
      replies.push_back(reply);
    }
  }
  return replies;
}

TEST(FalconPackets, RequestsMatchKnownPackets)
{
  EXPECT_EQ(TextOf({{0, 0, 0}, false, FalconLight::None}), "<AAAAAAAAAAAAAA>");
  EXPECT_EQ(TextOf({{0, 0, 0}, true, FalconLight::None}), "<AAAAAAAAAAAABA>");
  EXPECT_EQ(TextOf({{1, -1, 4095}, true, FalconLight::Green}), "<BAAAPPPPPPPADA>");
  EXPECT_EQ(TextOf({{-4096, 1447, -1447}, true, FalconLight::Blue}), "<AAAPHKFAJFKPFA>");
  EXPECT_EQ(TextOf({{100, -100, 2000}, true, FalconLight::Red}), "<EGAAMJPPANHAJA>");
}

TEST(FalconPackets, NumbersRoundTrip)
{
  FalconReplyParser parser;
  for (int value = std::numeric_limits<std::int16_t>::min();
       value <= std::numeric_limits<std::int16_t>::max(); ++value)
  {
    FalconReply sent;
    const auto number = static_cast<std::int16_t>(value);
    sent.Counts = {number, static_cast<std::int16_t>(~number), 0};
    sent.Homed = static_cast<unsigned>(value) & 7U;
    sent.Buttons = static_cast<unsigned>(value >> 3) & 15U;
    const FalconPacket packet = ReplyPacket(sent);
    const auto replies = Parsed(Bytes(packet.begin(), packet.end()), parser);
    ASSERT_EQ(replies.size(), 1U);
    ASSERT_TRUE(AreEqual(replies[0], sent)) << value;
  }
  EXPECT_EQ(parser.SkippedBytes(), 0U);
}

TEST(FalconReplyParser, LostByteAffectsOnlyItsReply)
{
  std::mt19937_64 random(21);
  for (std::size_t lost = 0; lost < FalconPacketSize; ++lost)
  {
    const FalconReply first = RandomReply(random);
    const FalconReply second = RandomReply(random);
    const FalconPacket a = ReplyPacket(first);
    const FalconPacket b = ReplyPacket(second);
    Bytes stream(a.begin(), a.end());
    stream.erase(stream.begin() + static_cast<std::ptrdiff_t>(lost));
    stream.insert(stream.end(), b.begin(), b.end());
    FalconReplyParser parser;
    const auto replies = Parsed(stream, parser);
    ASSERT_EQ(replies.size(), 1U) << lost;
    EXPECT_TRUE(AreEqual(replies[0], second)) << lost;
    EXPECT_EQ(parser.SkippedBytes(), FalconPacketSize - 1);
  }
}

TEST(FalconReplyParser, IgnoresStrayBytesBetweenReplies)
{
  std::mt19937_64 random(22);
  FalconReplyParser parser;
  for (int round = 0; round < 2000; ++round)
  {
    Bytes stream;
    for (std::size_t i = random() % 40; i > 0; --i)
    {
      stream.push_back(static_cast<std::uint8_t>(random()));
    }
    // Ends anything that the noise may have started.
    stream.insert(stream.end(), FalconPacketSize, 0x00);
    const FalconReply sent = RandomReply(random);
    const FalconPacket packet = ReplyPacket(sent, static_cast<std::uint8_t>(random()));
    stream.insert(stream.end(), packet.begin(), packet.end());
    const auto replies = Parsed(stream, parser);
    ASSERT_FALSE(replies.empty());
    ASSERT_TRUE(AreEqual(replies.back(), sent));
  }
}

// For any input, every byte is part of a reply, skipped, or pending, and every reply is well
// formed.
TEST(FalconReplyParser, SurvivesRandomStreams)
{
  std::mt19937_64 random(23);
  for (int round = 0; round < 300; ++round)
  {
    FalconReplyParser parser;
    Bytes stream;
    while (stream.size() < 2000)
    {
      const FalconPacket packet = ReplyPacket(RandomReply(random));
      stream.insert(stream.end(), packet.begin(), packet.end());
    }
    for (std::size_t fault = 0; fault < 60; ++fault)
    {
      const auto at = stream.begin() + static_cast<std::ptrdiff_t>(random() % stream.size());
      constexpr std::uint8_t tricky[] = {'<', '>', 'A', 'P', 0xC0, 0xC1, 0x00};
      const std::uint8_t byte =
          random() % 2 == 0 ? tricky[random() % 7] : static_cast<std::uint8_t>(random());
      switch (random() % 3)
      {
      case 0:
        *at = byte;
        break;
      case 1:
        stream.insert(at, byte);
        break;
      default:
        stream.erase(at);
      }
    }
    const std::size_t replies = Parsed(stream, parser).size();
    const std::size_t accounted = replies * FalconPacketSize + parser.SkippedBytes();
    ASSERT_LE(accounted, stream.size());
    ASSERT_LT(stream.size() - accounted, FalconPacketSize);
    // 60 faults affect 60 of 125 replies, one more where they merge.
    ASSERT_GE(replies, 125U - 60U);
  }
}
} // namespace
} // namespace palpate::falcon_packets_test
