#pragma once

#include "EncoderScreen.h"
#include "FalconLink.h"
#include "FalconPackets.h"
#include "FalconReplyParser.h"

#include <cstdint>

namespace palpate
{
/// Communication statistics since the exchange started.
struct FalconStatistics
{
  std::uint64_t Requests = 0;
  std::uint64_t Replies = 0;      ///< complete ones
  std::uint64_t Lost = 0;         ///< requests without a reply in time
  std::uint64_t Unasked = 0;      ///< replies beyond the requests: duplicate or late ones
  std::uint64_t Implausible = 0;  ///< replies with rejected counts
  std::uint64_t SkippedBytes = 0; ///< bytes outside of replies
};

/// Outcome of a request.
enum class FalconDelivery
{
  Sent, ///< handed to the link
  Held, ///< not sent: too many replies are outstanding, or the link's queue is full
  Gone  ///< not sent: the device is gone
};

/// The protocol with the running firmware: one request, one reply, at the caller's rate. A reply is
/// on the wire a quarter of a millisecond after its request, but the chip holds it for up to its
/// timer of 1 ms; so requests continue while a few replies are outstanding, and pause for
/// ReplyDeadline if more are missing. A request that removes the torque from the motors never waits
/// for replies, and overtakes data queued in the link (FalconLink::SendStop).
///
/// One thread only. Never waits or allocates.
class FalconExchange
{
public:
  static constexpr int MostOwed = 4;
  static constexpr std::int64_t ReplyDeadline = 8'000'000; // ns

  /// Keeps the link's address.
  explicit FalconExchange(FalconLink& link) noexcept : Link(&link) {}

  FalconDelivery Send(const FalconRequest& request, std::int64_t now) noexcept;
  /// Processes received data. Returns true if there is an accepted reply, the newest one.
  bool Receive(std::int64_t now, FalconReply& reply) noexcept;

  /// Time (ns) for which requests have had no complete reply; time in which the caller sends none
  /// does not count.
  std::int64_t Silence(std::int64_t now) const noexcept;
  const FalconStatistics& Statistics() const noexcept { return this->Counts; }

  /// Starts again: no outstanding and no partial replies.
  void Restart(std::int64_t now) noexcept;

private:
  void GiveUpReplies(std::int64_t now) noexcept;
  bool Accept(const FalconReply& reply, std::int64_t now) noexcept;
  bool HandToLink(const FalconRequest& request, bool mustStop) noexcept;

  FalconLink* Link;
  FalconReplyParser Parser;
  EncoderScreen Screen;
  FalconStatistics Counts;
  int Owed = 0;
  bool HasTorque = false; // of the newest request sent
  std::int64_t Sent = 0;  // ns, the newest request
  std::int64_t Replied = 0;
  bool IsAsking = false;       // requests were sent since the newest reply
  std::int64_t AskedSince = 0; // ns, time of the first of them
};
} // namespace palpate
