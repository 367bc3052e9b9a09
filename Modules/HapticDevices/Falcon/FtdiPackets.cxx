#include "FtdiPackets.h"

#include <algorithm>
#include <cstring>

namespace palpate
{
std::size_t FtdiPackets::Strip(const std::uint8_t* transfer, std::size_t count,
                               std::uint8_t* payload) noexcept
{
  std::size_t length = 0;
  for (std::size_t start = 0; start + StatusSize <= count; start += PacketSize)
  {
    const std::size_t packet = std::min(PacketSize, count - start);
    this->Modem = transfer[start];
    // Source and destination overlap if a transfer is stripped in place.
    std::memmove(payload + length, transfer + start + StatusSize, packet - StatusSize);
    length += packet - StatusSize;
  }
  return length;
}
} // namespace palpate
