#pragma once

#include "Vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Packets of the running firmware, one request and one reply of 16 bytes each: `<`, three numbers
/// of 16 bits as four nibbles each, lowest first, a byte of flags, one of unknown meaning, `>`. All
/// bytes between the delimiters are 0x41 plus a value, so that delimiters are unique.
constexpr std::size_t FalconPacketSize = 16;
using FalconPacket = std::array<std::uint8_t, FalconPacketSize>;
/// One number per leg: top, right, lower left as the user sees them.
using FalconNumbers = std::array<std::int16_t, 3>;

/// The lights of the handle, as bits of a request.
enum class FalconLight : unsigned
{
  None = 0,
  Green = 2,
  Blue = 4,
  Red = 8
};

/// A request of the host. It takes effect until the next one, or for some milliseconds.
struct FalconRequest
{
  FalconNumbers Motors{}; ///< within +-LargestMotorValue; a positive one pulls the grip in
  bool IsHoming = false;  ///< encoders are zeroed where they pass their index
  FalconLight Light = FalconLight::None;
};

/// Measurements of the device.
struct FalconReply
{
  FalconNumbers Counts{};
  unsigned Homed = 0;   ///< one bit per leg, from bit 0; only valid while homing was requested
  unsigned Buttons = 0; ///< of the sphere grip: plus, forward, centre, minus, from bit 0

  static constexpr unsigned AllHomed = 7;
};

/// Largest magnitude of a motor value.
constexpr double LargestMotorValue = 4095.0;

/// Motor values for torques at the thighs (N mm); a positive value turns a thigh inwards, where its
/// angle decreases. If one exceeds the limit all three are scaled together, which keeps the force's
/// direction; a value that wrapped round would pull the other way. NaN becomes 0.
FalconNumbers MotorValuesFor(const Vector3& torques, double countsPerNewtonMillimeter) noexcept;

FalconPacket Encoded(const FalconRequest& request) noexcept;

/// Whether these first `count` <= 16 bytes may begin a reply.
bool MayBeginReply(const std::uint8_t* bytes, std::size_t count) noexcept;
/// Decodes 16 bytes for which MayBeginReply is true.
FalconReply DecodedReply(const FalconPacket& packet) noexcept;
} // namespace palpate
