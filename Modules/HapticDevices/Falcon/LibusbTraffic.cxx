#include "LibusbTraffic.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr unsigned char EndpointIn = 0x81;
constexpr unsigned char EndpointOut = 0x02;
constexpr std::size_t SendCapacity = 512;     // bytes
constexpr std::size_t ReceiveCapacity = 8192; // bytes, 50 ms at the highest rate
constexpr unsigned Deadline = 1000;           // ms, of a write, a stop and a control request
constexpr int ReadFailureLimit = 32;          // errors on a cable come in bursts
constexpr auto Nap = 100ms;                   // longest sleep of the thread
constexpr auto OvertakingTime = 1ms;          // for writes before a stop to complete
constexpr auto SilenceTime = std::chrono::nanoseconds(FalconLink::SilenceLimit);
constexpr auto FlushTime = 250ms;
constexpr auto CancelTime = 1s;
constexpr auto StopPause = 5ms; // before a failed stop is sent again
constexpr const char* Unplugged = "The Falcon was unplugged: plug it in and open it again.";
constexpr const char* TakesNothing =
    "The Falcon takes no data: unplug it, plug it in and open it again.";
constexpr const char* WriteFails =
    "Writing to the Falcon fails: try another cable or another USB socket.";
constexpr const char* OnlyErrors =
    "Nothing but errors comes from the Falcon: try another cable or another USB socket.";

bool IsPurgeIn(const FtdiRequest& request)
{
  constexpr FtdiRequest Purge = FtdiRequest::PurgeIn();
  return request.Request == Purge.Request && request.Value == Purge.Value;
}
} // namespace

LibusbTraffic::LibusbTraffic(libusb_context* context, libusb_device_handle* handle,
                             std::function<void()> onUnplugged)
    : Handle(handle), Context(context), Events(context), OnUnplugged(std::move(onUnplugged)),
      Outgoing(SendCapacity), Incoming(ReceiveCapacity)
{
}

bool LibusbTraffic::Prepare(Transfer& transfer, unsigned char endpoint,
                            libusb_transfer_cb_fn finished, unsigned deadline)
{
  transfer.Owner = this;
  transfer.Call.reset(libusb_alloc_transfer(0));
  if (transfer.Call != nullptr)
  {
    libusb_fill_bulk_transfer(transfer.Call.get(), this->Handle, endpoint, transfer.Bytes.data(),
                              static_cast<int>(Transfer::Size), finished, &transfer, deadline);
  }
  return transfer.Call != nullptr;
}

bool LibusbTraffic::Prepare()
{
  constexpr unsigned Never = 0;
  return this->Prepare(this->ControlTransfer, 0, OnControl, Deadline) &&
         this->Prepare(this->StopTransfer, EndpointOut, OnStop, Never) &&
         std::all_of(this->Reads.begin(), this->Reads.end(),
                     [this](Transfer& read)
                     { return this->Prepare(read, EndpointIn, OnRead, Never); }) &&
         std::all_of(this->Writes.begin(), this->Writes.end(),
                     [this](Transfer& write)
                     { return this->Prepare(write, EndpointOut, OnWrite, Deadline); });
}

Status LibusbTraffic::Start()
{
  if (!this->Events.IsUsable() || !this->Prepare())
  {
    return Status::Failure("The system gives no memory or no descriptor for USB transfers.");
  }
  // Replies must be there when the servo reads them, so this thread requests the same priority; if
  // that is refused, the servo's request is refused too and reports it.
  return this->Thread.Start({}, [this] { this->Run(); });
}

bool LibusbTraffic::Stop() noexcept
{
  this->StopWanted.store(true, std::memory_order_release);
  this->Events.Wake();
  this->Thread.Join();
  return this->IsFlushed;
}

bool LibusbTraffic::Send(const std::uint8_t* bytes, std::size_t count) noexcept
{
  const bool isArmed = this->IsArmed.load(std::memory_order_relaxed);
  const std::size_t capacity = isArmed ? FalconLink::ArmedCapacity : SendCapacity;
  if (this->IsGone() || this->Unsent.load(std::memory_order_acquire) + count > capacity)
  {
    return false;
  }
  this->Unsent.fetch_add(count, std::memory_order_acq_rel);
  for (std::size_t n = 0; n < count; ++n)
  {
    this->Outgoing.Push(bytes[n]);
  }
  this->Events.Wake();
  return true;
}

void LibusbTraffic::ArmStop(const std::uint8_t* bytes, std::size_t count) noexcept
{
  this->IsArmed.store(false, std::memory_order_release);
  this->StopCount = std::min(count, this->StopBytes.size());
  std::copy_n(bytes, this->StopCount, this->StopBytes.begin());
  this->IsArmed.store(this->StopCount > 0, std::memory_order_release);
}

bool LibusbTraffic::SendStop() noexcept
{
  if (this->IsGone() || !this->IsArmed.load(std::memory_order_acquire))
  {
    return false;
  }
  this->MotorStopWanted.store(true, std::memory_order_release);
  this->Events.Wake();
  return true;
}

std::size_t LibusbTraffic::Receive(std::uint8_t* bytes, std::size_t capacity) noexcept
{
  std::size_t count = 0;
  while (count < capacity && this->Incoming.Pop(bytes[count]))
  {
    ++count;
  }
  return count;
}

Status LibusbTraffic::Control(FtdiRequest request)
{
  std::unique_lock<std::mutex> lock(this->ControlAccess);
  // An answer to an earlier request that timed out does not count.
  if (this->ControlLife == ControlState::Idle || this->ControlLife == ControlState::Finished)
  {
    this->ControlWanted = request;
    this->ControlLife = ControlState::Wanted;
    this->Events.Wake();
    // libusb ends the request at its deadline; data sent before may take as long.
    this->ControlChanged.wait_for(
        lock, std::chrono::milliseconds(2 * Deadline),
        [this] { return this->ControlLife == ControlState::Finished || this->IsGone(); });
  }
  if (this->ControlLife == ControlState::Wanted)
  {
    this->ControlLife = ControlState::Idle;
  }
  if (this->ControlLife != ControlState::Finished)
  {
    return Status::Failure(this->IsGone() ? this->GoneBecause : TakesNothing);
  }
  this->ControlLife = ControlState::Idle;
  Status answer = this->ControlAnswer(request.Request);
  std::uint8_t old = 0;
  while (answer.IsOk() && IsPurgeIn(request) && this->Incoming.Pop(old))
  {
  }
  return answer;
}

Status LibusbTraffic::ControlAnswer(std::uint8_t request) const
{
  const std::string what = "request " + std::to_string(request);
  switch (this->ControlOutcome)
  {
  case LIBUSB_TRANSFER_COMPLETED:
    return Status::Success();
  case LIBUSB_TRANSFER_STALL:
    return Status::Failure("The Falcon's serial chip refuses " + what + ".");
  case LIBUSB_TRANSFER_TIMED_OUT:
    return Status::Failure("The Falcon's serial chip does not answer " + what +
                           ": unplug it and plug it in again.");
  case LIBUSB_TRANSFER_NO_DEVICE:
    return Status::Failure(Unplugged);
  default:
    return Status::Failure("The Falcon's serial chip could not be asked " + what +
                           ": unplug it and plug it in again.");
  }
}

void LibusbTraffic::Run() noexcept
{
  for (Transfer& read : this->Reads)
  {
    this->Submit(read);
  }
  while (!this->StopWanted.load(std::memory_order_acquire))
  {
    this->StartStop();
    this->StartWrites();
    this->StartControl();
    this->Step(this->NextWake(steady_clock::now()));
  }
  const auto flushed = steady_clock::now() + FlushTime;
  while (this->HasUnsent() && steady_clock::now() < flushed)
  {
    this->StartStop();
    this->StartWrites();
    this->Step(std::min(flushed, this->NextWake(steady_clock::now())));
  }
  this->IsFlushed = !this->HasUnsent();
  this->CancelAll();
  const auto cancelled = steady_clock::now() + CancelTime;
  while (this->HasInFlight() && steady_clock::now() < cancelled)
  {
    this->Step(cancelled);
  }
}

bool LibusbTraffic::HasUnsent() const noexcept
{
  return this->StopTransfer.IsInFlight || this->MotorStopWanted.load() ||
         (!this->IsGone() && this->Unsent.load() > 0);
}

// Waits for an event, at most until then, and runs libusb's callbacks of finished transfers.
void LibusbTraffic::Step(LibusbPoll::TimePoint until) noexcept
{
  this->Events.Wait(until, !this->IsGone());
  timeval none{};
  static_cast<void>(libusb_handle_events_timeout_completed(this->Context, &none, nullptr));
}

void LibusbTraffic::Submit(Transfer& transfer) noexcept
{
  const int answer = libusb_submit_transfer(transfer.Call.get());
  transfer.IsInFlight = answer == LIBUSB_SUCCESS;
  if (!transfer.IsInFlight)
  {
    this->StopNotBefore = steady_clock::now() + StopPause;
    this->GiveUp(answer == LIBUSB_ERROR_NO_DEVICE ? Unplugged : WriteFails);
  }
}

void LibusbTraffic::DropQueue() noexcept
{
  std::uint8_t old = 0;
  while (this->Outgoing.Pop(old))
  {
    this->Unsent.fetch_sub(1, std::memory_order_acq_rel);
  }
}

// Only if something was sent, so that an idle device is left alone.
bool LibusbTraffic::IsServoSilent(LibusbPoll::TimePoint now) const noexcept
{
  return this->IsArmed.load(std::memory_order_acquire) && this->StopsLeft > 0 &&
         now - std::max(this->LastSent, this->OvertakingSince) >= SilenceTime;
}

LibusbPoll::TimePoint LibusbTraffic::NextWake(LibusbPoll::TimePoint now) const noexcept
{
  LibusbPoll::TimePoint wake = now + Nap;
  if (this->StopTransfer.IsInFlight)
  {
    const LibusbPoll::TimePoint overtaken = this->OvertakingSince + OvertakingTime;
    wake = overtaken > now ? std::min(wake, overtaken) : wake;
  }
  if (this->StopsLeft > 0 && this->IsArmed.load(std::memory_order_acquire))
  {
    wake = std::min(wake, std::max(this->LastSent, this->OvertakingSince) + SilenceTime);
  }
  return wake;
}

void LibusbTraffic::SubmitStop(LibusbPoll::TimePoint now) noexcept
{
  if (!this->StopTransfer.IsInFlight)
  {
    this->OvertakingSince = now;
    std::copy_n(this->StopBytes.begin(), this->StopCount, this->StopTransfer.Bytes.begin());
    this->StopTransfer.Call->length = static_cast<int>(this->StopCount);
    this->Submit(this->StopTransfer);
  }
}

void LibusbTraffic::StartStop() noexcept
{
  const LibusbPoll::TimePoint now = steady_clock::now();
  if (now >= this->StopNotBefore &&
      this->MotorStopWanted.exchange(false, std::memory_order_acq_rel))
  {
    this->DropQueue();
    this->SubmitStop(now);
  }
  else if (this->IsServoSilent(now))
  {
    --this->StopsLeft;
    this->SubmitStop(now);
  }
  if (this->StopTransfer.IsInFlight && now - this->OvertakingSince >= OvertakingTime)
  {
    std::for_each(this->Writes.begin(), this->Writes.end(), Cancel);
  }
  if (this->StopTransfer.IsInFlight && !this->IsGone() &&
      now - this->OvertakingSince >= std::chrono::milliseconds(Deadline))
  {
    this->GiveUp(TakesNothing);
  }
}

void LibusbTraffic::StartWrites() noexcept
{

  for (Transfer& write : this->Writes)
  {
    std::size_t count = 0;
    // Data after a stop waits for it in the queue.
    const bool isFree = !write.IsInFlight && !this->StopTransfer.IsInFlight && !this->IsGone();
    while (isFree && count < Transfer::Size && this->Outgoing.Pop(write.Bytes[count]))
    {
      ++count;
    }
    if (count > 0)
    {
      this->LastSent = steady_clock::now();
      this->StopsLeft = FalconLink::StopRepeats;
      write.Call->length = static_cast<int>(count);
      this->Submit(write);
    }
  }
}

bool LibusbTraffic::TakeControl() noexcept
{
  const std::lock_guard<std::mutex> lock(this->ControlAccess);
  if (this->ControlLife != ControlState::Wanted || this->Unsent.load() > 0 || this->IsGone())
  {
    return false;
  }
  constexpr int VendorOut =
      int{LIBUSB_ENDPOINT_OUT} | int{LIBUSB_REQUEST_TYPE_VENDOR} | int{LIBUSB_RECIPIENT_DEVICE};
  libusb_fill_control_setup(this->ControlTransfer.Bytes.data(), VendorOut,
                            this->ControlWanted.Request, this->ControlWanted.Value,
                            this->ControlWanted.Index, 0);
  this->ControlLife = ControlState::InFlight;
  return true;
}

void LibusbTraffic::StartControl() noexcept
{
  if (this->TakeControl())
  {
    Transfer& transfer = this->ControlTransfer;
    libusb_fill_control_transfer(transfer.Call.get(), this->Handle, transfer.Bytes.data(),
                                 OnControl, &transfer, Deadline);
    this->Submit(transfer);
  }
}

void LibusbTraffic::FinishRead(Transfer& read) noexcept
{
  switch (read.Call->status)
  {
  case LIBUSB_TRANSFER_COMPLETED:
  {
    this->FailedReads = 0;
    const std::size_t count = this->Packets.Strip(
        read.Bytes.data(), static_cast<std::size_t>(read.Call->actual_length), read.Bytes.data());
    for (std::size_t n = 0; n < count; ++n)
    {
      this->Incoming.Push(read.Bytes[n]);
    }
    this->Clear.store(this->Packets.ClearToSend(), std::memory_order_release);
    break;
  }
  case LIBUSB_TRANSFER_CANCELLED:
    return;
  case LIBUSB_TRANSFER_NO_DEVICE:
    this->GiveUp(Unplugged);
    return;
  default:
    if (++this->FailedReads > ReadFailureLimit)
    {
      this->GiveUp(OnlyErrors);
      return;
    }
  }
  if (!this->StopWanted.load(std::memory_order_acquire))
  {
    this->Submit(read);
  }
}

void LibusbTraffic::FinishWrite(Transfer& write) noexcept
{
  const libusb_transfer& call = *write.Call;
  this->Unsent.fetch_sub(static_cast<std::size_t>(call.length), std::memory_order_acq_rel);
  const bool isWhole =
      call.status == LIBUSB_TRANSFER_COMPLETED && call.actual_length == call.length;
  if (!isWhole && call.status != LIBUSB_TRANSFER_CANCELLED)
  {
    this->GiveUp(call.status == LIBUSB_TRANSFER_TIMED_OUT   ? TakesNothing
                 : call.status == LIBUSB_TRANSFER_NO_DEVICE ? Unplugged
                                                            : WriteFails);
  }
}

void LibusbTraffic::FinishStop(libusb_transfer_status outcome) noexcept
{
  if (outcome == LIBUSB_TRANSFER_NO_DEVICE)
  {
    this->GiveUp(Unplugged);
  }
  else if (outcome != LIBUSB_TRANSFER_COMPLETED && outcome != LIBUSB_TRANSFER_CANCELLED)
  {
    this->StopNotBefore = steady_clock::now() + StopPause;
    this->GiveUp(WriteFails); // which sends it again
  }
}

void LibusbTraffic::FinishControl(libusb_transfer_status outcome) noexcept
{
  {
    const std::lock_guard<std::mutex> lock(this->ControlAccess);
    this->ControlOutcome = outcome;
    this->ControlLife = ControlState::Finished;
  }
  this->ControlChanged.notify_all();
}

// Stops the motors if the device still receives.
void LibusbTraffic::GiveUp(const char* reason) noexcept
{
  this->MotorStopWanted.store(this->IsArmed.load() && reason != Unplugged);
  bool isFirst = false;
  {
    const std::lock_guard<std::mutex> lock(this->ControlAccess);
    isFirst = !this->IsGone();
    this->GoneBecause = isFirst ? reason : this->GoneBecause;
    this->Gone.store(true, std::memory_order_release);
  }
  this->ControlChanged.notify_all();
  const bool leaves = reason == Unplugged && !std::exchange(this->HasLeft, true);
  if (leaves && this->OnUnplugged != nullptr)
  {
    this->OnUnplugged();
  }
}

void LibusbTraffic::Cancel(const Transfer& transfer) noexcept
{
  if (transfer.IsInFlight)
  {
    // Transfers that have finished meanwhile still call back.
    static_cast<void>(libusb_cancel_transfer(transfer.Call.get()));
  }
}

void LibusbTraffic::CancelAll() noexcept
{
  std::for_each(this->Reads.begin(), this->Reads.end(), Cancel);
  std::for_each(this->Writes.begin(), this->Writes.end(), Cancel);
  Cancel(this->ControlTransfer);
  Cancel(this->StopTransfer);
}

bool LibusbTraffic::HasInFlight() const noexcept
{
  const auto isInFlight = [](const Transfer& transfer) { return transfer.IsInFlight; };
  return std::any_of(this->Reads.begin(), this->Reads.end(), isInFlight) ||
         std::any_of(this->Writes.begin(), this->Writes.end(), isInFlight) ||
         isInFlight(this->ControlTransfer) || isInFlight(this->StopTransfer);
}

void LibusbTraffic::OnRead(libusb_transfer* call) noexcept
{
  auto* const read = static_cast<Transfer*>(call->user_data);
  read->IsInFlight = false;
  read->Owner->FinishRead(*read);
}

void LibusbTraffic::OnWrite(libusb_transfer* call) noexcept
{
  auto* const write = static_cast<Transfer*>(call->user_data);
  write->IsInFlight = false;
  write->Owner->FinishWrite(*write);
}

void LibusbTraffic::OnStop(libusb_transfer* call) noexcept
{
  auto* const stop = static_cast<Transfer*>(call->user_data);
  stop->IsInFlight = false;
  stop->Owner->FinishStop(call->status);
}

void LibusbTraffic::OnControl(libusb_transfer* call) noexcept
{
  auto* const control = static_cast<Transfer*>(call->user_data);
  control->IsInFlight = false;
  control->Owner->FinishControl(call->status);
}
} // namespace palpate
