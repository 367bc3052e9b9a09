#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace palpate::test
{
/// An answer of a virtual Falcon's board before it goes on the wire.
struct VirtualFalconAnswer
{
  enum class Kind
  {
    Greeting, ///< four bytes of the loader's first stage
    BaudLock, ///< the letter echoed once the loader has detected the rate
    Echo,     ///< a byte of the firmware
    Run       ///< 16 bytes of the running firmware
  };
  Kind What = Kind::Run;
  std::uint64_t Number = 0; ///< of its kind, from 0, since the last reset of the board
  int Resets = 0;           ///< of the board so far, by DTR or power
  std::vector<std::uint8_t> Bytes;
  std::int64_t Delay = 0; ///< ns until the first byte starts
  std::int64_t Gap = 0;   ///< ns between one byte and the next
  bool Unplugs = false;   ///< the cable is unplugged once it is sent
};

/// Faults of a virtual Falcon. The functions decide by numbers, not by random numbers of their own,
/// so that a run is reproducible.
struct VirtualFalconFaults
{
  /// Changes an answer in any way: empties it (lost), shortens, corrupts, duplicates or delays it.
  std::function<void(VirtualFalconAnswer&)> Spoil;
  bool HasSupply = true;         ///< without, the chip is on the bus and the board is mute
  bool RaisesClearToSend = true; ///< the loader reports ready
  bool StartsFirmware = true;    ///< loaded firmware runs
  double FastestUpload = 1e9;    ///< Bd, above which the loader does not detect the rate
  /// ns without a packet until the board switches its motors off. The real one's behaviour was
  /// never measured, so by default it holds the last torque for ever.
  std::int64_t TorqueLapse = std::numeric_limits<std::int64_t>::max();
  int StalledRequest = -1;         ///< bRequest that the chip refuses
  std::uint64_t UnplugAtReply = 0; ///< the running firmware's answer at which the cable is
                                   ///< unplugged, counted from 1; 0 is never
};
} // namespace palpate::test
