#pragma once

#include "VirtualFalconFaults.h"
#include "VirtualFtdiChip.h"
#include "VirtualMechanism.h"

#include <array>
#include <cstdint>
#include <vector>

namespace palpate::test
{
/// The board behind a virtual Falcon's serial chip: the two stages of its boot loader, then the
/// running firmware. The firmware itself is not run: any image in the loader's format starts the
/// built-in behaviour.
class VirtualFalconBoard
{
public:
  enum class State
  {
    Off,      ///< no power, or nothing loaded and not reset yet
    Greeting, ///< after the edge of DTR, at 9600 Bd
    BaudLock, ///< greeted and DTR off: detects the rate from one letter
    Loading,  ///< receives and echoes the image
    Running
  };

  /// A valid packet: its completion time (ns), and the requested motor values.
  struct Order
  {
    std::int64_t Time;
    std::array<std::int16_t, 3> Motors;
    bool HasTorque() const { return this->Motors != std::array<std::int16_t, 3>{}; }
  };

  void SetDataTerminalReady(bool level, std::int64_t now, VirtualFtdiChip& chip);
  /// Receives a byte from the wire and may answer.
  void Receive(const VirtualFtdiChip::WireByte& byte, VirtualFtdiChip& chip,
               VirtualMechanism& mechanism, const VirtualFalconFaults& faults);
  /// Time of its next spontaneous event, and processing it.
  std::int64_t NextEvent() const;
  void Advance(std::int64_t now, VirtualFtdiChip& chip, VirtualMechanism& mechanism,
               const VirtualFalconFaults& faults);
  /// Loses the loaded firmware.
  void PowerOff();
  /// Starts running at once, as if another program had loaded it. `Replies` keep counting.
  void StartLoaded() { this->Life = State::Running; }

  State Now() const { return this->Life; }
  bool WantsUnplug() const { return this->Unplugs; }
  int Resets() const { return this->ResetCount; }
  /// Image bytes received since the last reset.
  const std::vector<std::uint8_t>& Image() const { return this->Loaded; }
  /// Motor values of the last valid packet.
  const std::array<std::int16_t, 3>& Motors() const { return this->Commanded; }
  /// Every valid packet since construction, whatever happened to its power.
  const std::vector<Order>& Received() const { return this->Orders; }
  unsigned Flags() const { return this->Asked; }
  std::uint64_t Packets() const { return this->PacketCount; }       ///< valid ones
  std::uint64_t BadPackets() const { return this->BadPacketCount; } ///< since power-up
  std::uint64_t Replies() const { return this->Numbers.back(); }    ///< since the last reset

private:
  void Greet(std::uint8_t value, VirtualFtdiChip& chip, const VirtualFalconFaults& faults);
  void Lock(const VirtualFtdiChip::WireByte& byte, VirtualFtdiChip& chip,
            const VirtualFalconFaults& faults);
  void Load(std::uint8_t value, VirtualFtdiChip& chip, const VirtualFalconFaults& faults);
  void TakeWord(unsigned word);
  void Run(std::uint8_t value, VirtualFtdiChip& chip, VirtualMechanism& mechanism,
           const VirtualFalconFaults& faults);
  void Obey(VirtualFtdiChip& chip, VirtualMechanism& mechanism, const VirtualFalconFaults& faults);
  void Answer(VirtualFalconAnswer::Kind kind, std::vector<std::uint8_t> bytes, std::int64_t delay,
              VirtualFtdiChip& chip, const VirtualFalconFaults& faults);

  State Life = State::Off;
  bool Dtr = false;
  bool Unplugs = false;
  int ResetCount = 0;
  double Baud = 9600.0; // the board's rate
  std::int64_t Time = 0;
  std::int64_t WireFree = 0;
  std::int64_t RaiseClearToSend = VirtualFtdiChip::Never;
  std::int64_t Start = VirtualFtdiChip::Never;
  std::int64_t Lapse = VirtualFtdiChip::Never;
  std::vector<std::uint8_t> Frame; // partial greeting or packet
  std::vector<std::uint8_t> Loaded;
  std::uint64_t WordsLeft = 0; // of the current part of the image
  int Part = 0;                // 0 head, 1 size of a block, 2 its address, 3 its words
  std::array<std::int16_t, 3> Commanded{};
  std::vector<Order> Orders;
  unsigned Asked = 0;
  std::uint64_t PacketCount = 0;
  std::uint64_t BadPacketCount = 0;
  std::array<std::uint64_t, 4> Numbers{}; // of answers by kind
};
} // namespace palpate::test
