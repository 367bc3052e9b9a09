#pragma once

#include "Vector3.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace palpate
{
/// What a message of Haply's service says of one Inverse3 (docs.haply.co, Inverse SDK 3.1 to 3.5).
/// Places and forces are here in the device's frame of this program: x to the right, y up, z
/// towards the person; the service has y forward and z up, and metres.
struct Inverse3Frame
{
  std::string Id;
  bool IsFull = false;             ///< the first message, which has the configuration
  bool HasPresets = false;         ///< a service of 3.5 or later, which takes forces as "vector"
  bool IsSmall = false;            ///< a Minverse
  bool IsIdle = false;             ///< it displays no force
  std::optional<Vector3> Position; ///< mm
  Vector3 Displayed = Vector3::Zero(); ///< N, as the device says, after the service's filters
  std::optional<Eigen::Quaterniond> Orientation; ///< of a VerseGrip; unit
  std::uint32_t Buttons = 0;                     ///< of it: a, b, c
};

/// Reads one. Of several devices it is the one with this id, or the first one for an empty id.
/// Returns nothing for what is not JSON of that shape, or has no such device.
std::optional<Inverse3Frame> ReadInverse3Frame(std::string_view text, const std::string& id);

/// A force (N, this program's frame) for a device. `isFirst` adds what the service wants to know
/// once: a name, and a frame in the middle of the reach if it has presets.
std::string Inverse3ForceMessage(const std::string& id, const Vector3& force, bool asVector,
                                 bool isFirst, bool hasPresets);

/// Whether an event of the service forbids forces of this device from now on; then what to say to
/// the person. Nothing for others.
std::optional<std::string> Inverse3Alarm(std::string_view text, const std::string& id);
} // namespace palpate
