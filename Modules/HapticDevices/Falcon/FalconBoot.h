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
/// Where a boot is, or ended.
enum class FalconBootStep
{
  Setup,    ///< of the serial chip
  Greeting, ///< of the boot loader, at 9600 Bd
  RateLock, ///< the loader finds the rate of the upload
  Upload,   ///< bytes come back as they were sent
  Start,    ///< the firmware answers
  Done
};

/// What a boot did.
struct FalconBootReport
{
  FalconBootStep Step = FalconBootStep::Setup; ///< the last attempt's
  int Attempts = 0;                            ///< uploads begun; 0 where the firmware ran already
  bool IsSlow = false;                         ///< the last one was at the lower rate
};

/// Brings a Falcon to where its firmware answers, over an open link. Firmware that runs already is
/// left alone. Else the loader is asked for, the image sent, each byte of it compared as it comes
/// back, and the start waited for; whatever fails is tried again, from a freshly opened link, with
/// a lower rate in turn (the loader finds its rate unreliably above 100 kBd). Any number of bytes
/// may come in pieces, late, or before them what does not belong there.
///
/// For the owner's thread: takes seconds, and waits by the clock. Keeps both addresses.
class FalconBoot
{
public:
  static constexpr int MostAttempts = 10;
  /// What the serial chip has to be told before the running firmware is talked to: the timer, 1.5
  /// MBd, eight bits, no flow control, nothing left in its queues.
  static constexpr std::array<FtdiRequest, 6> RunMode() noexcept
  {
    return {FtdiRequest::LatencyTimer(1), FtdiRequest::Baud(2),    FtdiRequest::EightDataBits(),
            FtdiRequest::NoFlowControl(), FtdiRequest::PurgeOut(), FtdiRequest::PurgeIn()};
  }

  FalconBoot(FalconLink& link, Clock& clock) noexcept : Link(link), Time(clock) {}

  /// `firmwarePath` may be empty if the firmware runs already. On failure one sentence names the
  /// step and what to do; the link may then be open or closed.
  Status Run(const std::string& firmwarePath);
  const FalconBootReport& Report() const noexcept { return this->Account; }

private:
  Status Attempt(const FalconFirmware& firmware);
  Status Reopen();
  Status Greet();
  Status LockRate();
  Status Upload(const FalconFirmware& firmware);
  Status SwitchToRunning();
  bool Answers(int rounds);
  Status Command(std::initializer_list<FtdiRequest> requests);
  Status SendAll(const std::uint8_t* bytes, std::size_t count);
  bool WaitForByte(std::int64_t deadline, std::uint8_t& byte);
  bool WaitForBytes(const std::uint8_t* wanted, std::size_t count, std::int64_t duration);
  void Wait(std::int64_t duration) { this->Time.WaitUntil(this->Time.Now() + duration); }
  Status Unplugged() const;

  FalconLink& Link;
  Clock& Time;
  FalconBootReport Account;
};
} // namespace palpate
