#pragma once

#include "PlainVector3.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// What a program that displays a touch is told of one tick. Can be copied as bytes.
struct IgtlTouch
{
  PlainVector3 ProbeWorld;     ///< the tool, mm, LPS
  PlainVector3 ProxyWorld;     ///< where it would be if it could not enter anything, mm, LPS
  PlainVector3 ForceWorld;     ///< on the hand, N, LPS
  std::int32_t Structure = -1; ///< the one that is touched, from 0; -1 without contact
  const char* Fault = "";      ///< why forces are off; empty while they are on. Not owned
  std::uint64_t Tick = 0;      ///< its number, from 1
};

/// The messages for a peer that was told `before`: TRANSFORM Probe and Proxy (mm), SENSOR
/// ContactForce (N), in RAS as other programs expect it of the patient, and STRING Event when a
/// contact begins or ends and when forces go off or on.
std::vector<std::uint8_t> IgtlTouchMessages(const IgtlTouch& before, const IgtlTouch& now);
} // namespace palpate
