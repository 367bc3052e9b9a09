#pragma once

#include "FalconPackets.h"

#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Finds replies in a stream of bytes. Where bytes were lost, added or changed it goes on with the
/// next that can begin a reply, so that no fault costs more than the replies that it touches.
class FalconReplyParser
{
public:
  /// True where the byte completes a reply.
  bool Take(std::uint8_t byte, FalconReply& reply) noexcept;
  /// Forgets a reply that has begun.
  void Restart() noexcept { this->Count = 0; }
  /// Bytes so far that belonged to no reply.
  std::uint64_t SkippedBytes() const noexcept { return this->Skipped; }

private:
  FalconPacket Window{};
  std::size_t Count = 0; // bytes in the window, which may begin a reply
  std::uint64_t Skipped = 0;
};
} // namespace palpate
