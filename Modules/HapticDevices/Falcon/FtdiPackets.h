#pragma once

#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Unpacks data from an FTDI chip: every packet of at most 64 bytes starts with two status bytes,
/// so a longer transfer has them once in every 64 bytes. A packet of status only means that there
/// is no data.
class FtdiPackets
{
public:
  static constexpr std::size_t PacketSize = 64;
  static constexpr std::size_t StatusSize = 2;

  /// Copies the payload of one IN transfer of `count` bytes and returns its length, which is less
  /// than `count` or 0. `payload` holds `count` bytes; it may be `transfer` itself. A packet of one
  /// byte, which no chip sends, is ignored.
  std::size_t Strip(const std::uint8_t* transfer, std::size_t count,
                    std::uint8_t* payload) noexcept;

  /// From the newest packet; false before the first.
  bool ClearToSend() const noexcept { return (this->Modem & 0x10U) != 0; }

private:
  std::uint8_t Modem = 0; // first byte of the status
};
} // namespace palpate
