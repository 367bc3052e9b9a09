#pragma once

#include "EncoderScreen.h"
#include "FalconLink.h"
#include "FalconPackets.h"
#include "FalconReplyParser.h"

#include <cstdint>

namespace palpate
{
/// What happened on the wire since the exchange started.
struct FalconStatistics
{
  std::uint64_t Requests = 0;
  std::uint64_t Replies = 0;      ///< whole ones
  std::uint64_t Lost = 0;         ///< requests that got no reply in time
  std::uint64_t Unasked = 0;      ///< replies beyond the requests: doubled ones, or late ones
  std::uint64_t Implausible = 0;  ///< replies whose counts were not believed
  std::uint64_t SkippedBytes = 0; ///< that belonged to no reply
};

/// What became of a request.
enum class FalconDelivery
{
  Sent, ///< handed to the link
  Held, ///< not sent: too many replies are owed, or the link's queue is full
  Gone  ///< not sent: the device is gone
};

/// The conversation with the running firmware: one request, one reply, at whatever rate the caller
/// keeps. A reply is on the wire a quarter of a millisecond after its request, but the chip holds
/// it for up to its timer of 1 ms; so requests go on while a few replies are owed, and stop for
/// ReplyDeadline where more are missing. A request that takes the torque off the motors never waits
/// for replies, and overtakes what the link has queued (FalconLink::SendStop).
///
/// All on one thread. Nothing waits or allocates.
class FalconExchange
{
public:
  static constexpr int MostOwed = 4;
  static constexpr std::int64_t ReplyDeadline = 8'000'000; // ns

  /// Keeps the link's address.
  explicit FalconExchange(FalconLink& link) noexcept : Link(&link) {}

  FalconDelivery Send(const FalconRequest& request, std::int64_t now) noexcept;
  /// Takes what has come. True where there is a reply to be believed; it is the newest one.
  bool Receive(std::int64_t now, FalconReply& reply) noexcept;

  /// For how long (ns) requests have had no whole reply; time in which the caller sends none does
  /// not count.
  std::int64_t Silence(std::int64_t now) const noexcept;
  const FalconStatistics& Statistics() const noexcept { return this->Counts; }

  /// Begins anew: no replies are owed, none is half there.
  void Restart(std::int64_t now) noexcept;
  /// The next counts need not go on from the last ones, as when encoders took their zero.
  void ExpectJump() noexcept { this->Screen.Restart(); }

private:
  void GiveUpReplies(std::int64_t now) noexcept;
  bool Accept(const FalconReply& reply, std::int64_t now) noexcept;
  bool HandToLink(const FalconRequest& request, bool mustStop) noexcept;

  FalconLink* Link;
  FalconReplyParser Parser;
  EncoderScreen Screen;
  FalconStatistics Counts;
  int Owed = 0;
  bool HasTorque = false; // the newest request that was sent had one
  std::int64_t Sent = 0;  // ns, the newest request
  std::int64_t Replied = 0;
  bool IsAsking = false;       // requests were sent since the newest reply
  std::int64_t AskedSince = 0; // ns, the first of them
};
} // namespace palpate
