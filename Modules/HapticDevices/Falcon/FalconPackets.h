#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Packets of the running firmware, one request and one reply of 16 bytes each, both ways: `<`,
/// three numbers of 16 bits as four nibbles lowest first, a byte of flags, one unknown, `>`. All
/// between the marks are 0x41 plus a value, so that a mark is never anything else.
constexpr std::size_t FalconPacketSize = 16;
using FalconPacket = std::array<std::uint8_t, FalconPacketSize>;
/// Of the three legs: top, right, lower left as the user sees them.
using FalconNumbers = std::array<std::int16_t, 3>;

/// The lights of the handle, as bits of a request.
enum class FalconLight : unsigned
{
  None = 0,
  Green = 2,
  Blue = 4,
  Red = 8
};

/// What the host asks for. It holds until the next request, or for some milliseconds.
struct FalconRequest
{
  FalconNumbers Motors{}; ///< within +-LargestMotorValue; a positive one pulls the grip in
  bool IsHoming = false;  ///< encoders take their zero where they pass their index
  FalconLight Light = FalconLight::None;
};

/// What the device measures.
struct FalconReply
{
  FalconNumbers Counts{};
  unsigned Homed = 0;   ///< a bit a leg, from bit 0; only true while homing was asked for
  unsigned Buttons = 0; ///< of the ball grip: plus, forward, centre, minus, from bit 0

  static constexpr unsigned AllHomed = 7;
};

FalconPacket Encoded(const FalconRequest& request) noexcept;

/// Whether these first `count` <= 16 bytes may begin a reply.
bool MayBeginReply(const std::uint8_t* bytes, std::size_t count) noexcept;
/// Of 16 bytes that may.
FalconReply DecodedReply(const FalconPacket& packet) noexcept;
} // namespace palpate
