#include "FalconBoot.h"

#include "FalconReplyParser.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
constexpr std::int64_t Millisecond = 1'000'000;          // ns
constexpr std::int64_t Poll = Millisecond / 2;           // between polls for bytes
constexpr std::int64_t Hold = 10 * Millisecond;          // of the line that resets the board
constexpr std::int64_t GreetingTime = 150 * Millisecond; // until the next greeting
constexpr std::int64_t ReadyTime = 100 * Millisecond;    // until the loader reports ready
constexpr std::int64_t EchoTime = 500 * Millisecond;     // until a portion is echoed
constexpr std::int64_t AnswerTime = 20 * Millisecond;    // until the next request
constexpr std::int64_t RetryPause = 100 * Millisecond;   // with the link closed
constexpr int Greetings = 5;
constexpr int Rounds = 15; // of requests: on a busy machine answers are late
// The echo fills one packet, which the chip then sends without waiting for its timer.
constexpr std::size_t Portion = 62;
constexpr unsigned UploadDivisor = 21; // 142,857 Bd, as in the manufacturer's software
constexpr unsigned SlowDivisor = 52;   // 57,692 Bd
constexpr unsigned GreetingDivisor = 312;
constexpr unsigned GreetingEighths = 4; // 9600 Bd
constexpr int FastInARow = 2;           // attempts before a slow one

constexpr std::array<std::uint8_t, 3> Greeting{0x0A, 0x43, 0x0D};
constexpr std::array<std::uint8_t, 4> GreetingAnswer{0x0A, 0x44, 0x2C, 0x0D};
constexpr std::uint8_t LockLetter = 0x41;
} // namespace

Status FalconBoot::Unplugged() const
{
  return Status::Failure("The Falcon was unplugged while it was being started.");
}

Status FalconBoot::Command(std::initializer_list<FtdiRequest> requests)
{
  Status status = Status::Success();
  for (const FtdiRequest& request : requests)
  {
    status = this->Link.Control(request);
    if (this->Link.IsGone())
    {
      return this->Unplugged();
    }
    if (!status.IsOk())
    {
      return Status::Failure("The Falcon's serial chip could not be set up: " + status.Message());
    }
  }
  return status;
}

Status FalconBoot::SendAll(const std::uint8_t* bytes, std::size_t count)
{
  return this->Link.Send(bytes, count) ? Status::Success() : this->Unplugged();
}

bool FalconBoot::WaitForByte(std::int64_t deadline, std::uint8_t& byte)
{
  while (this->Link.Receive(&byte, 1) == 0)
  {
    if (this->Time.Now() >= deadline || this->Link.IsGone())
    {
      return false;
    }
    this->Wait(Poll);
  }
  return true;
}

// Consecutive bytes, with anything before them.
bool FalconBoot::WaitForBytes(const std::uint8_t* wanted, std::size_t count, std::int64_t duration)
{
  std::array<std::uint8_t, 8> tail{};
  const std::int64_t deadline = this->Time.Now() + duration;
  while (this->WaitForByte(deadline, tail.back()))
  {
    if (std::equal(wanted, wanted + count, tail.end() - static_cast<std::ptrdiff_t>(count)))
    {
      return true;
    }
    std::rotate(tail.begin(), tail.begin() + 1, tail.end());
  }
  return false;
}

Status FalconBoot::Greet()
{
  Status status =
      this->Command({FtdiRequest::PurgeOut(), FtdiRequest::PurgeIn(), FtdiRequest::LatencyTimer(16),
                     FtdiRequest::Baud(GreetingDivisor, GreetingEighths),
                     FtdiRequest::EightDataBits(), FtdiRequest::NoFlowControl(),
                     FtdiRequest::RequestToSend(false), FtdiRequest::DataTerminalReady(false)});
  if (!status.IsOk())
  {
    return status;
  }
  // The edge resets the board into its loader; its minimum length was never measured.
  this->Wait(Hold);
  status = this->Command({FtdiRequest::DataTerminalReady(true)});
  for (int n = 0; n < Greetings && status.IsOk(); ++n)
  {
    status = this->SendAll(Greeting.data(), Greeting.size());
    if (this->WaitForBytes(GreetingAnswer.data(), GreetingAnswer.size(), GreetingTime))
    {
      return Status::Success();
    }
  }
  return !status.IsOk() || this->Link.IsGone()
             ? this->Unplugged()
             : Status::Failure("The Falcon's boot loader does not answer: check that its power "
                               "supply is connected, then unplug its USB cable, plug it in and "
                               "try again.");
}

Status FalconBoot::LockRate(bool isSlow)
{
  const unsigned divisor = isSlow ? SlowDivisor : UploadDivisor;
  Status status = this->Command(
      {FtdiRequest::DataTerminalReady(false), FtdiRequest::Baud(divisor), FtdiRequest::PurgeIn()});
  if (!status.IsOk())
  {
    return status;
  }
  // Awaited but not required: it is unknown whether every Falcon reports it.
  const std::int64_t deadline = this->Time.Now() + ReadyTime;
  std::uint8_t ignored = 0;
  while (!this->Link.ClearToSend() && this->Time.Now() < deadline)
  {
    static_cast<void>(this->WaitForByte(this->Time.Now(), ignored));
    this->Wait(Poll);
  }
  // Once only: a second letter would be taken as the image's first byte.
  status = this->SendAll(&LockLetter, 1);
  if (status.IsOk() && this->WaitForBytes(&LockLetter, 1, EchoTime))
  {
    return Status::Success();
  }
  return !status.IsOk() || this->Link.IsGone()
             ? this->Unplugged()
             : Status::Failure("The Falcon's boot loader greets, but does not find the rate at "
                               "which its firmware is sent: unplug it from any hub, plug it in "
                               "directly and try again.");
}

Status FalconBoot::Upload(const FalconFirmware& firmware)
{
  const auto& image = firmware.Bytes();
  for (std::size_t first = 0; first < image.size(); first += Portion)
  {
    const std::size_t count = std::min(Portion, image.size() - first);
    Status status = this->SendAll(image.data() + first, count);
    const std::int64_t deadline = this->Time.Now() + EchoTime;
    for (std::size_t i = first; i < first + count && status.IsOk(); ++i)
    {
      std::uint8_t echo = 0;
      const bool hasCome = this->WaitForByte(deadline, echo);
      if (this->Link.IsGone())
      {
        return this->Unplugged();
      }
      if (!hasCome || echo != image[i])
      {
        return Status::Failure("The Falcon's firmware could not be loaded: byte " +
                               std::to_string(i) + " of " + std::to_string(image.size()) +
                               (hasCome ? " came back changed" : " did not come back") +
                               "; try another cable or another USB port.");
      }
    }
    if (!status.IsOk())
    {
      return status;
    }
  }
  return Status::Success();
}

Status FalconBoot::SwitchToRunning()
{
  Status status = Status::Success();
  for (const FtdiRequest& request : RunMode())
  {
    status = status.IsOk() ? this->Command({request}) : status;
  }
  return status;
}

// No request exists that only queries the firmware, so a request without torque is used. DTR is not
// touched, since its edge would reset firmware and homing.
bool FalconBoot::Answers()
{
  FalconRequest request;
  request.IsHoming = true;
  request.Light = FalconLight::Red;
  const FalconPacket packet = Encoded(request);
  FalconReplyParser parser;
  FalconReply reply;
  for (int round = 0; round < Rounds && this->Link.Send(packet.data(), packet.size()); ++round)
  {
    const std::int64_t deadline = this->Time.Now() + AnswerTime;
    std::uint8_t byte = 0;
    while (this->WaitForByte(deadline, byte))
    {
      if (parser.Take(byte, reply))
      {
        return true;
      }
    }
  }
  return false;
}

Status FalconBoot::Attempt(const FalconFirmware& firmware, bool isSlow)
{
  Status status = this->Greet();
  status = status.IsOk() ? this->LockRate(isSlow) : status;
  status = status.IsOk() ? this->Upload(firmware) : status;
  if (!status.IsOk())
  {
    return status;
  }
  status = this->SwitchToRunning();
  if (!status.IsOk() || this->Answers())
  {
    return status;
  }
  return this->Link.IsGone()
             ? this->Unplugged()
             : Status::Failure(firmware.Name() + " was loaded and came back unchanged, but does "
                                                 "not run: check that it is a Falcon's firmware.");
}

Status FalconBoot::Reopen()
{
  this->Link.Close();
  this->Wait(RetryPause);
  return this->Link.Open();
}

Status FalconBoot::Run(const std::string& firmwarePath)
{
  Status status = this->SwitchToRunning();
  if (!status.IsOk() || this->Answers())
  {
    return status;
  }
  if (firmwarePath.empty())
  {
    return Status::Failure("The Falcon has no firmware loaded and none is named: give the path of "
                           "its firmware file, which comes with the maker's software, or set "
                           "PALPATE_FALCON_FIRMWARE to it.");
  }
  FalconFirmware firmware;
  status = FalconFirmware::Read(firmwarePath, firmware);
  if (!status.IsOk())
  {
    return status;
  }
  for (int n = 0; n < MostAttempts; ++n)
  {
    status = n == 0 ? Status::Success() : this->Reopen();
    if (status.IsOk())
    {
      status = this->Attempt(firmware, n % (FastInARow + 1) == FastInARow);
    }
    if (status.IsOk() || this->Link.IsGone())
    {
      return status;
    }
  }
  return status;
}
} // namespace palpate
