#pragma once

#include "FtdiRequest.h"
#include "Status.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace palpate
{
/// The cable to a Falcon: the serial chip in it, and bytes to and from the board behind the chip.
/// Whatever really carries them (libusb, a test's model) is behind this.
///
/// Two threads at most. The owner's opens, closes and controls; it sends and receives too, but only
/// while no servo runs, as when it loads the firmware. The servo's sends and receives, and asks
/// ClearToSend and IsGone. A thread of the link's own may stand behind both.
class FalconLink
{
public:
  FalconLink() = default;
  FalconLink(const FalconLink&) = delete;
  FalconLink& operator=(const FalconLink&) = delete;
  /// Of an open one: closes it.
  virtual ~FalconLink() = default;

  /// Finds and claims the device. On failure nothing is claimed, and one sentence names the
  /// obstacle and what to do about it. The chip's settings stay as they are.
  virtual Status Open() = 0;
  /// Returns once the device is released; what is queued and not yet sent may be lost. Nothing
  /// where it is closed.
  virtual void Close() noexcept = 0;

  /// Has the chip do what is asked and waits for its answer, up to a second. Never on the tick
  /// path. Bytes received before a purge that took effect are not given out after it.
  virtual Status Control(FtdiRequest request) = 0;

  /// Queues bytes and returns at once, without allocating; all are taken, or none. False where the
  /// device is gone, the link closed or its queue full. An empty queue takes 512 bytes; while a
  /// stop is armed only ArmedCapacity, so that few old torques can wait in it.
  virtual bool Send(const std::uint8_t* bytes, std::size_t count) noexcept = 0;

  /// Says which bytes stop the motors (StopCapacity at most; none disarms). From then on a link
  /// that has a thread of its own sends them by itself, up to StopRepeats times, where something
  /// was sent and then nothing for SilenceLimit: a servo that hangs must not leave its last torque
  /// on the motors. Owner's thread, while no servo runs; a link that is opened is not armed.
  virtual void ArmStop(const std::uint8_t* bytes, std::size_t count) noexcept = 0;
  /// Sends the armed bytes before anything else: what is queued and has not gone out is dropped,
  /// and while the device takes nothing they stay first in line. Neither waits nor allocates. False
  /// where nothing is armed or the device is gone.
  virtual bool SendStop() noexcept = 0;

  static constexpr std::size_t StopCapacity = 16;          // bytes
  static constexpr std::size_t ArmedCapacity = 64;         // bytes, four packets
  static constexpr std::int64_t SilenceLimit = 20'000'000; // ns
  static constexpr int StopRepeats = 5;

  /// Takes what the board sent and has not been taken, in order and without the chip's status
  /// bytes; returns how many bytes, 0 where there are none. Never waits or allocates.
  virtual std::size_t Receive(std::uint8_t* bytes, std::size_t capacity) noexcept = 0;

  /// The level of the chip's CTS pin in the newest status that came. False before the first.
  virtual bool ClearToSend() const noexcept = 0;
  /// The device was unplugged or fails for good since it was opened; it has to be closed and opened
  /// again.
  virtual bool IsGone() const noexcept = 0;
  /// What the person at the device should know about this connection; mostly empty. Owner's thread.
  virtual std::string Caution() const { return ""; }
};
} // namespace palpate
