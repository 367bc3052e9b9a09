#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>

namespace palpate::test
{
/// The serial chip of a virtual Falcon: an FT232R between USB packets and a wire of bytes, in
/// virtual time (ns), which must not decrease from call to call. Implements FTDI's vendor protocol,
/// not the driver's code.
class VirtualFtdiChip
{
public:
  static constexpr std::int64_t Never = std::numeric_limits<std::int64_t>::max();

  /// A byte on the wire, complete at `Time`, sent at `Baud`.
  struct WireByte
  {
    std::int64_t Time;
    double Baud;
    std::uint8_t Value;
  };

  /// False for a request that stalls.
  bool ControlOut(std::uint8_t request, std::uint16_t value, std::uint16_t index, std::int64_t now);
  /// Bytes answered, or -1 for a request that stalls.
  int ControlIn(std::uint8_t request, std::uint8_t* bytes, std::size_t capacity) const;

  /// From the host: bytes are transmitted one by one at the current baud rate.
  void Transmit(const std::uint8_t* bytes, std::size_t count, std::int64_t now);
  /// To the board: the next byte that is complete by `now`.
  bool TakeTransmitted(std::int64_t now, WireByte& byte);
  std::int64_t NextTransmitted() const;

  /// From the board; in order of time. A byte at another rate than the chip's arrives corrupted.
  void Receive(const WireByte& byte);
  void SetClearToSend(bool level, std::int64_t now);

  /// The next IN packet that is due by `now`, with its two bytes of status; 0 if there is none. As
  /// if reads had been pending all the time, except that consecutive unread packets of status only
  /// are merged.
  std::size_t TakePacket(std::uint8_t* packet, std::int64_t now);
  /// Time of the next packet, as far as known now.
  std::int64_t NextPacket() const;

  double Baud() const { return this->Rate; }
  bool DataTerminalReady() const { return this->Dtr; }
  bool RequestToSend() const { return this->Rts; }
  /// The board's own rates match this one closely enough for a serial line (3 %).
  static bool Matches(double baud, double other);

private:
  void SetBaud(std::uint16_t value, std::uint16_t index);
  void Purge(std::uint16_t which);
  std::uint8_t ModemStatus() const;

  double Rate = 9600.0;
  std::int64_t Latency = 16'000'000;
  bool Dtr = false;
  bool Rts = false;
  bool Cts = false;
  bool StatusChanged = false;
  std::int64_t StatusTime = 0;
  int EventCharacter = -1;
  std::int64_t LastPacket = 0;
  std::int64_t WireFree = 0;
  bool Framing = false; // an error since the last packet
  std::deque<WireByte> Outgoing;
  std::deque<WireByte> Incoming;
};
} // namespace palpate::test
