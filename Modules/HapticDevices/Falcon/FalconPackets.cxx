#include "FalconPackets.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr std::uint8_t Begin = 0x3C;
constexpr std::uint8_t End = 0x3E;
constexpr unsigned Base = 0x41;
constexpr std::size_t FlagsAt = 13;
constexpr std::size_t UnknownAt = 14;

bool MayStandAt(std::size_t place, std::uint8_t byte) noexcept
{
  if (place == 0)
  {
    return byte == Begin;
  }
  if (place < FlagsAt)
  {
    return byte >= Base && byte <= Base + 15;
  }
  if (place == FlagsAt)
  {
    return byte >= Base && byte <= Base + 127;
  }
  return place == UnknownAt || byte == End;
}
} // namespace

FalconNumbers MotorValuesFor(const Vector3& torques, double countsPerNewtonMillimeter) noexcept
{
  const Vector3 values = -countsPerNewtonMillimeter * torques;
  FalconNumbers motors{};
  if (values.allFinite())
  {
    const double scale =
        LargestMotorValue / std::max(LargestMotorValue, values.cwiseAbs().maxCoeff());
    for (int leg = 0; leg < 3; ++leg)
    {
      motors[static_cast<std::size_t>(leg)] =
          static_cast<std::int16_t>(std::lround(scale * values[leg]));
    }
  }
  return motors;
}

FalconPacket Encoded(const FalconRequest& request) noexcept
{
  FalconPacket packet;
  packet.fill(Base);
  packet.front() = Begin;
  packet.back() = End;
  std::size_t place = 1;
  for (const std::int16_t motor : request.Motors)
  {
    const auto bits = static_cast<std::uint16_t>(motor);
    for (unsigned shift = 0; shift < 16; shift += 4)
    {
      packet[place++] = static_cast<std::uint8_t>(Base + ((bits >> shift) & 0xFU));
    }
  }
  packet[FlagsAt] = static_cast<std::uint8_t>(Base + static_cast<unsigned>(request.Light) +
                                              (request.IsHoming ? 1U : 0U));
  return packet;
}

bool MayBeginReply(const std::uint8_t* bytes, std::size_t count) noexcept
{
  for (std::size_t place = 0; place < count; ++place)
  {
    if (!MayStandAt(place, bytes[place]))
    {
      return false;
    }
  }
  return true;
}

FalconReply DecodedReply(const FalconPacket& packet) noexcept
{
  FalconReply reply;
  std::size_t place = 1;
  for (std::int16_t& count : reply.Counts)
  {
    unsigned bits = 0;
    for (unsigned shift = 0; shift < 16; shift += 4)
    {
      bits |= ((packet[place++] - Base) & 0xFU) << shift;
    }
    count = static_cast<std::int16_t>(static_cast<std::uint16_t>(bits));
  }
  const unsigned flags = packet[FlagsAt] - Base;
  reply.Homed = flags >> 4U;
  reply.Buttons = flags & 0xFU;
  return reply;
}
} // namespace palpate
