#pragma once

#include "Clock.h"
#include "FalconFirmware.h"
#include "FalconLink.h"
#include "Status.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace palpate
{
/// Starts a Falcon's firmware over an open link. Running firmware is kept. Otherwise it resets the
/// board into its loader, sends the image, compares the echo of each byte, and waits for the
/// firmware to answer; a failure at any step is retried from a reopened link, alternating with a
/// lower rate (the loader's rate detection is unreliable above 100 kBd). Answers may be fragmented,
/// late, or preceded by stray bytes.
///
/// Owner thread only: takes seconds, and waits by the clock. Keeps the addresses of both arguments.
class FalconBoot
{
public:
  static constexpr int MostAttempts = 10;
  /// Settings of the serial chip for the running firmware: latency timer, 1.5 MBd, eight bits, no
  /// flow control, empty queues.
  static constexpr std::array<FtdiRequest, 6> RunMode() noexcept
  {
    return {FtdiRequest::LatencyTimer(1), FtdiRequest::Baud(2),    FtdiRequest::EightDataBits(),
            FtdiRequest::NoFlowControl(), FtdiRequest::PurgeOut(), FtdiRequest::PurgeIn()};
  }

  FalconBoot(FalconLink& link, Clock& clock) noexcept : Link(link), Time(clock) {}

  /// `firmwarePath` may be empty if the firmware is running. On failure the message names the step
  /// and the remedy; the link may then be open or closed.
  Status Run(const std::string& firmwarePath);

private:
  Status Attempt(const FalconFirmware& firmware, bool isSlow);
  Status Reopen();
  Status Greet();
  Status LockRate(bool isSlow);
  Status Upload(const FalconFirmware& firmware);
  Status SwitchToRunning();
  bool Answers();
  Status Command(std::initializer_list<FtdiRequest> requests);
  Status SendAll(const std::uint8_t* bytes, std::size_t count);
  bool WaitForByte(std::int64_t deadline, std::uint8_t& byte);
  bool WaitForBytes(const std::uint8_t* wanted, std::size_t count, std::int64_t duration);
  void Wait(std::int64_t duration) { this->Time.WaitUntil(this->Time.Now() + duration); }
  Status Unplugged() const;

  FalconLink& Link;
  Clock& Time;
};
} // namespace palpate
