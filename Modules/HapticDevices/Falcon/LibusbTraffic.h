#pragma once

#include "FalconLink.h"
#include "FtdiPackets.h"
#include "FtdiRequest.h"
#include "LibusbPoll.h"
#include "RealtimeThread.h"
#include "RingBuffer.h"
#include "Status.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <libusb.h>
#include <memory>
#include <mutex>

namespace palpate
{
/// Data traffic with an open and claimed Falcon, on a thread of its own. libusb allocates and locks
/// whenever a transfer is submitted, so only that thread calls it; senders and receivers have ring
/// buffers, and the thread sleeps in poll until the device or a sender wakes it. Several reads are
/// always in flight, so that no packet is missed while one is unpacked.
///
/// A stop (FalconLink::ArmStop) has a transfer of its own without a deadline. Earlier writes that
/// have not completed within a millisecond are cancelled, so that it is first when the device takes
/// data again.
///
/// For the two threads of FalconLink.
class LibusbTraffic
{
public:
  /// Keeps both, which must outlive it. The thread calls `onUnplugged` once if the device has left
  /// the bus.
  LibusbTraffic(libusb_context* context, libusb_device_handle* handle,
                std::function<void()> onUnplugged = nullptr);
  LibusbTraffic(const LibusbTraffic&) = delete;
  LibusbTraffic& operator=(const LibusbTraffic&) = delete;
  ~LibusbTraffic() { this->Stop(); }

  Status Start();
  /// Waits up to 0.25 s for queued data to be sent, then up to a second to cancel transfers.
  /// Returns true if all data, including a stop, was sent. Does nothing if it does not run.
  bool Stop() noexcept;

  /// As in FalconLink. A control request starts once all data sent before has been transmitted.
  Status Control(FtdiRequest request);
  bool Send(const std::uint8_t* bytes, std::size_t count) noexcept;
  void ArmStop(const std::uint8_t* bytes, std::size_t count) noexcept;
  bool SendStop() noexcept;
  std::size_t Receive(std::uint8_t* bytes, std::size_t capacity) noexcept;
  bool ClearToSend() const noexcept { return this->Clear.load(std::memory_order_acquire); }
  bool IsGone() const noexcept { return this->Gone.load(std::memory_order_acquire); }

private:
  struct TransferReleaser
  {
    void operator()(libusb_transfer* transfer) const noexcept { libusb_free_transfer(transfer); }
  };
  struct Transfer
  {
    static constexpr std::size_t Size = 512; // bytes, whole packets of 64
    LibusbTraffic* Owner = nullptr;
    std::unique_ptr<libusb_transfer, TransferReleaser> Call;
    std::array<std::uint8_t, Size> Bytes{};
    bool IsInFlight = false;
  };
  enum class ControlState
  {
    Idle,
    Wanted,
    InFlight,
    Finished
  };

  bool Prepare();
  bool Prepare(Transfer& transfer, unsigned char endpoint, libusb_transfer_cb_fn finished,
               unsigned deadline);
  void Run() noexcept;
  void Step(LibusbPoll::TimePoint until) noexcept;
  void Submit(Transfer& transfer) noexcept;
  void StartWrites() noexcept;
  void StartStop() noexcept;
  void SubmitStop(LibusbPoll::TimePoint now) noexcept;
  void DropQueue() noexcept;
  bool IsServoSilent(LibusbPoll::TimePoint now) const noexcept;
  LibusbPoll::TimePoint NextWake(LibusbPoll::TimePoint now) const noexcept;
  bool TakeControl() noexcept;
  void StartControl() noexcept;
  void FinishRead(Transfer& read) noexcept;
  void FinishWrite(Transfer& write) noexcept;
  void FinishStop(libusb_transfer_status outcome) noexcept;
  bool HasUnsent() const noexcept;
  void FinishControl(libusb_transfer_status outcome) noexcept;
  void GiveUp(const char* reason) noexcept;
  static void Cancel(const Transfer& transfer) noexcept;
  void CancelAll() noexcept;
  bool HasInFlight() const noexcept;
  Status ControlAnswer(std::uint8_t request) const;
  static void LIBUSB_CALL OnRead(libusb_transfer* call) noexcept;
  static void LIBUSB_CALL OnWrite(libusb_transfer* call) noexcept;
  static void LIBUSB_CALL OnStop(libusb_transfer* call) noexcept;
  static void LIBUSB_CALL OnControl(libusb_transfer* call) noexcept;

  libusb_device_handle* Handle;
  libusb_context* Context;
  LibusbPoll Events;
  std::function<void()> OnUnplugged;
  RealtimeThread Thread;
  std::atomic<bool> StopWanted{false};
  std::atomic<bool> Gone{false};
  std::atomic<bool> Clear{false};
  std::atomic<bool> IsArmed{false};         // StopBytes are set
  std::atomic<bool> MotorStopWanted{false}; // by a sender, or after a failure
  std::array<std::uint8_t, FalconLink::StopCapacity> StopBytes{};
  std::size_t StopCount = 0;

  RingBuffer<std::uint8_t> Outgoing;
  RingBuffer<std::uint8_t> Incoming;
  std::atomic<std::size_t> Unsent{0}; // bytes accepted by Send and not yet by the device

  std::mutex ControlAccess; // guards the next four
  std::condition_variable ControlChanged;
  ControlState ControlLife = ControlState::Idle;
  libusb_transfer_status ControlOutcome = LIBUSB_TRANSFER_COMPLETED;
  FtdiRequest ControlWanted;
  const char* GoneBecause = "";

  // Used by the thread only.
  std::array<Transfer, 4> Reads;
  std::array<Transfer, 4> Writes;
  Transfer ControlTransfer;
  Transfer StopTransfer;
  LibusbPoll::TimePoint LastSent;        // when data was taken from the queue
  LibusbPoll::TimePoint OvertakingSince; // when StopTransfer was submitted
  LibusbPoll::TimePoint StopNotBefore;   // after a failed one
  bool HasLeft = false;                  // the bus; reported to OnUnplugged
  bool IsFlushed = true;                 // at the thread's end
  int StopsLeft = 0;                     // that silence may still trigger
  FtdiPackets Packets;
  int FailedReads = 0; // consecutive
};
} // namespace palpate
