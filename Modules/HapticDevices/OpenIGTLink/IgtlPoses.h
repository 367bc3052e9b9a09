#pragma once

#include "PlainVector3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// A pose from a TRANSFORM message.
struct IgtlPose
{
  PlainVector3 Position;                                 ///< mm
  std::array<double, 4> Orientation{0.0, 0.0, 0.0, 1.0}; ///< unit quaternion, x, y, z, w
};

/// Finds the poses in a stream of OpenIGTLink messages, of which it may get any number of bytes at
/// a time. Other messages are skipped, whatever their length, without being kept; so are poses that
/// are damaged (CRC), not finite, or far from a rotation. Source: OpenIGTLink protocol 1 to 3,
/// header and TRANSFORM.
class IgtlPoses
{
public:
  /// Poses of this device name only; empty: of the first that sends one.
  explicit IgtlPoses(std::string name = {}) : Name(std::move(name)) {}

  /// Returns false if what arrives cannot be OpenIGTLink: nothing after it can be understood.
  bool Take(const std::uint8_t* bytes, std::size_t count);
  /// The newest pose since the last call; null if there is none.
  const IgtlPose* Newest() noexcept;
  std::uint64_t Refused() const noexcept { return this->Damaged; }

private:
  bool BeginMessage();
  void EndMessage();

  std::string Name;
  std::vector<std::uint8_t> Message; ///< header, then the body of a TRANSFORM
  std::uint64_t BodyLeft = 0;        ///< bytes still to come
  bool HasHeader = false;
  bool IsKept = false; ///< it may be a pose
  IgtlPose Last;
  bool IsFresh = false;
  std::uint64_t Damaged = 0;
};
} // namespace palpate
