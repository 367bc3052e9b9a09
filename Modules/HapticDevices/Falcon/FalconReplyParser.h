#pragma once

#include "FalconPackets.h"

#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Finds replies in a stream of bytes. After lost, added or changed bytes it resynchronises at the
/// next possible start of a reply, so that a fault affects only the replies that it touches.
class FalconReplyParser
{
public:
  /// Returns true if the byte completes a reply.
  bool Take(std::uint8_t byte, FalconReply& reply) noexcept;
  /// Number of bytes so far outside of replies.
  std::uint64_t SkippedBytes() const noexcept { return this->Skipped; }

private:
  FalconPacket Window{};
  std::size_t Count = 0; // bytes in the window, a possible start of a reply
  std::uint64_t Skipped = 0;
};
} // namespace palpate
