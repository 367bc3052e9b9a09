#pragma once

#include "IgtlParser.h"
#include "PlainVector3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace palpate
{
/// A pose from a TRANSFORM message.
struct IgtlPose
{
  PlainVector3 Position;                                 ///< mm
  std::array<double, 4> Orientation{0.0, 0.0, 0.0, 1.0}; ///< unit quaternion, x, y, z, w
};

/// The poses in a stream of OpenIGTLink messages, of which it may get any number of bytes at a
/// time, and how many forces the peer says that it has read: one for each STATUS message named
/// Force. Other messages are skipped; so are poses that are damaged, not finite, or far from a
/// rotation. Source: OpenIGTLink protocol 1 to 3, TRANSFORM and STATUS.
class IgtlPoses
{
public:
  /// Poses of this device name only; empty: of the first that sends one.
  explicit IgtlPoses(std::string name = {}) : Name(std::move(name)) {}

  /// Returns false if what arrives cannot be OpenIGTLink: nothing after it can be understood.
  bool Take(const std::uint8_t* bytes, std::size_t count);
  /// The newest pose since the last call; null if there is none.
  const IgtlPose* Newest() noexcept;
  std::uint64_t ForcesRead() const noexcept { return this->Confirmed; }
  std::uint64_t Refused() const noexcept { return this->Parser.Damaged() + this->NoPoses; }

private:
  /// With the extended header and metadata of version 3.
  static constexpr std::uint64_t MostPoseBytes = 4096;

  std::string Name;
  IgtlParser Parser{{{"TRANSFORM", MostPoseBytes}, {"STATUS", MostPoseBytes}}};
  IgtlPose Last;
  bool IsFresh = false;
  std::uint64_t NoPoses = 0;
  std::uint64_t Confirmed = 0;
};
} // namespace palpate
