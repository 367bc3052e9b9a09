#pragma once

#include "FtdiRequest.h"
#include "Status.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace palpate
{
/// The cable to a Falcon: its serial chip, and bytes to and from the board behind the chip.
/// Implemented by libusb and by a model for tests.
///
/// Two threads at most. The owner thread opens, closes and controls; it sends and receives too, but
/// only while no servo runs, as when it loads the firmware. The servo thread sends and receives,
/// and calls ClearToSend and IsGone. The link may have a thread of its own in addition.
class FalconLink
{
public:
  FalconLink() = default;
  FalconLink(const FalconLink&) = delete;
  FalconLink& operator=(const FalconLink&) = delete;
  /// Closes an open link.
  virtual ~FalconLink() = default;

  /// Finds and claims the device. On failure nothing is claimed, and the message names the obstacle
  /// and the remedy. The chip's settings are not changed.
  virtual Status Open() = 0;
  /// Returns once the device is released; queued data may be lost. Does nothing if closed.
  virtual void Close() noexcept = 0;

  /// Sends a request to the chip and waits up to a second for its answer. Never from a tick. Bytes
  /// received before a successful purge are not returned after it.
  virtual Status Control(FtdiRequest request) = 0;

  /// Queues bytes and returns at once, without allocating; takes all or none. Returns false if the
  /// device is gone, the link closed or its queue full. An empty queue takes 512 bytes; while a
  /// stop is armed only ArmedCapacity, so that few old torques can wait in it.
  virtual bool Send(const std::uint8_t* bytes, std::size_t count) noexcept = 0;

  /// Sets the bytes that stop the motors (at most StopCapacity; none disarms). From then on a link
  /// with a thread of its own sends them by itself, up to StopRepeats times, if data was sent and
  /// then nothing for SilenceLimit: a servo that hangs must not leave its last torque on the
  /// motors. Owner thread, while no servo runs; a newly opened link is not armed.
  virtual void ArmStop(const std::uint8_t* bytes, std::size_t count) noexcept = 0;
  /// Sends the armed bytes before anything else: queued data is dropped, and while the device takes
  /// nothing they stay first in the queue. Neither waits nor allocates. Returns false if nothing is
  /// armed or the device is gone.
  virtual bool SendStop() noexcept = 0;

  static constexpr std::size_t StopCapacity = 16;          // bytes
  static constexpr std::size_t ArmedCapacity = 64;         // bytes, four packets
  static constexpr std::int64_t SilenceLimit = 20'000'000; // ns
  static constexpr int StopRepeats = 5;

  /// Takes bytes received from the board, in order and without the chip's status bytes; returns
  /// their number, 0 if there are none. Never waits or allocates.
  virtual std::size_t Receive(std::uint8_t* bytes, std::size_t capacity) noexcept = 0;

  /// The level of the chip's CTS pin in the newest status. False before the first.
  virtual bool ClearToSend() const noexcept = 0;
  /// The device was unplugged or failed permanently since it was opened; it must be closed and
  /// opened again.
  virtual bool IsGone() const noexcept = 0;
  /// A warning about this connection for the user; usually empty. Owner thread.
  virtual std::string Caution() const { return ""; }
};
} // namespace palpate
