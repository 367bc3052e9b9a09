#pragma once

#include <cstdint>

namespace palpate
{
/// One vendor request to an FTDI serial chip without data: bmRequestType 0x40, host to device.
/// Numbers are those of the FT232R's vendor protocol.
struct FtdiRequest
{
  std::uint8_t Request = 0; ///< bRequest
  std::uint16_t Value = 0;  ///< wValue
  std::uint16_t Index = 0;  ///< wIndex

  /// Discards bytes from the host that the chip has not transmitted yet.
  static constexpr FtdiRequest PurgeOut() noexcept { return {0, 1, 0}; }
  /// Discards bytes that the chip received and the host has not read yet.
  static constexpr FtdiRequest PurgeIn() noexcept { return {0, 2, 0}; }
  static constexpr FtdiRequest DataTerminalReady(bool on) noexcept
  {
    return {1, static_cast<std::uint16_t>(on ? 0x0101 : 0x0100), 0};
  }
  static constexpr FtdiRequest RequestToSend(bool on) noexcept
  {
    return {1, static_cast<std::uint16_t>(on ? 0x0202 : 0x0200), 0};
  }
  static constexpr FtdiRequest NoFlowControl() noexcept { return {2, 0, 0}; }
  /// 3 MBd / (whole + eighths / 8), `whole` >= 2, `eighths` in 0..7.
  static constexpr FtdiRequest Baud(unsigned whole, unsigned eighths = 0) noexcept
  {
    constexpr unsigned codes[8] = {0, 3, 2, 4, 1, 5, 6, 7};
    const unsigned code = codes[eighths % 8];
    return {3, static_cast<std::uint16_t>((whole & 0x3FFFU) | (code & 3U) << 14U),
            static_cast<std::uint16_t>(code >> 2U)};
  }
  /// Eight bits, no parity, one stop bit.
  static constexpr FtdiRequest EightDataBits() noexcept { return {4, 0x0008, 0}; }
  /// Time (1..255 ms) for which the chip waits for a packet to fill before it sends it.
  static constexpr FtdiRequest LatencyTimer(unsigned milliseconds) noexcept
  {
    return {9, static_cast<std::uint16_t>(milliseconds), 0};
  }
};
} // namespace palpate
