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
/// What goes to and from an open and claimed Falcon, on a thread of its own. libusb allocates and
/// locks wherever a transfer is handed to it, so only that thread calls it; senders and receivers
/// have rings, and the thread sleeps in poll until the device or a sender wakes it. Several reads
/// are always in flight, so that no packet is missed while one is taken apart.
///
/// A stop (FalconLink::ArmStop) has a transfer of its own without a deadline. Writes that are in
/// flight before it and have not gone out within a millisecond are cancelled, so that it is first
/// when the device takes data again.
///
/// For the two threads of FalconLink.
class LibusbTraffic
{
public:
  /// Keeps both, which must outlive it. `onUnplugged` is called by the thread, once, where the
  /// device has left the bus.
  LibusbTraffic(libusb_context* context, libusb_device_handle* handle,
                std::function<void()> onUnplugged = nullptr);
  LibusbTraffic(const LibusbTraffic&) = delete;
  LibusbTraffic& operator=(const LibusbTraffic&) = delete;
  ~LibusbTraffic() { this->Stop(); }

  Status Start();
  /// Lets what was sent go out, for at most 0.25 s, and takes back what is in flight, for at most a
  /// second. True where all that was sent, a stop too, has gone out. Nothing where it does not run.
  bool Stop() noexcept;

  /// As FalconLink's. A control request begins once all that was sent before has gone out.
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
  std::atomic<std::size_t> Unsent{0}; // bytes that Send took and the device did not yet

  std::mutex ControlAccess; // of the next four
  std::condition_variable ControlChanged;
  ControlState ControlLife = ControlState::Idle;
  libusb_transfer_status ControlOutcome = LIBUSB_TRANSFER_COMPLETED;
  FtdiRequest ControlWanted;
  const char* GoneBecause = "";

  // The thread's own.
  std::array<Transfer, 4> Reads;
  std::array<Transfer, 4> Writes;
  Transfer ControlTransfer;
  Transfer StopTransfer;
  LibusbPoll::TimePoint LastSent;        // when something was taken from the queue
  LibusbPoll::TimePoint OvertakingSince; // when StopTransfer was submitted
  LibusbPoll::TimePoint StopNotBefore;   // after one that failed
  bool HasLeft = false;                  // the bus; said to OnUnplugged
  bool IsFlushed = true;                 // at the thread's end
  int StopsLeft = 0;                     // that silence may still cause
  FtdiPackets Packets;
  int FailedReads = 0; // one after the other
};
} // namespace palpate
