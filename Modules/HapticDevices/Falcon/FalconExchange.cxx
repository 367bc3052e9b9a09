#include "FalconExchange.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
constexpr std::int64_t Promptness = 3'000'000; // ns, longest time from a request to its reply
constexpr int MostPortions = 16;               // of received data per call, which bounds its time
} // namespace

void FalconExchange::Restart(std::int64_t now) noexcept
{
  this->Parser = {};
  this->Screen.Restart();
  this->Counts = {};
  this->Owed = 0;
  this->Sent = now;
  this->Replied = now;
  this->IsAsking = false;
  this->HasTorque = false;
}

std::int64_t FalconExchange::Silence(std::int64_t now) const noexcept
{
  return this->IsAsking ? std::min(now, this->Sent + ReplyDeadline) - this->AskedSince : 0;
}

void FalconExchange::GiveUpReplies(std::int64_t now) noexcept
{
  const bool isOverdue = now - std::max(this->Sent, this->Replied) >= ReplyDeadline;
  // Replies are in order: while they arrive, only the newest can be outstanding.
  const bool isAnswering = this->Owed >= MostOwed && now - this->Replied < Promptness;
  const int underway = isOverdue ? 0 : isAnswering ? 1 : this->Owed;
  if (this->Owed > underway)
  {
    this->Counts.Lost += static_cast<std::uint64_t>(this->Owed - underway);
    this->Owed = underway;
  }
}

bool FalconExchange::HandToLink(const FalconRequest& request, bool mustStop) noexcept
{
  if (mustStop && this->Link->SendStop())
  {
    return true;
  }
  const FalconPacket packet = Encoded(request);
  return this->Link->Send(packet.data(), packet.size());
}

FalconDelivery FalconExchange::Send(const FalconRequest& request, std::int64_t now) noexcept
{
  this->GiveUpReplies(now);
  const bool hasTorque = request.Motors != FalconNumbers{};
  const bool mustStop = this->HasTorque && !hasTorque;
  if (this->Owed >= MostOwed && !mustStop)
  {
    return FalconDelivery::Held;
  }
  this->AskedSince = this->IsAsking ? this->AskedSince : now;
  this->IsAsking = true;
  this->Sent = now;
  if (!this->HandToLink(request, mustStop))
  {
    // A full queue means that the device is not receiving; Silence measures for how long.
    return this->Link->IsGone() ? FalconDelivery::Gone : FalconDelivery::Held;
  }
  ++this->Counts.Requests;
  ++this->Owed;
  this->HasTorque = hasTorque;
  return FalconDelivery::Sent;
}

bool FalconExchange::Accept(const FalconReply& reply, std::int64_t now) noexcept
{
  ++this->Counts.Replies;
  this->Replied = now;
  this->IsAsking = false;
  this->Counts.Unasked += this->Owed > 0 ? 0 : 1;
  this->Owed -= this->Owed > 0 ? 1 : 0;
  const bool isBelieved = this->Screen.Believes(reply.Counts, now);
  this->Counts.Implausible += isBelieved ? 0 : 1;
  return isBelieved;
}

bool FalconExchange::Receive(std::int64_t now, FalconReply& reply) noexcept
{
  std::array<std::uint8_t, 256> bytes{};
  bool isNew = false;
  std::size_t count = bytes.size();
  for (int portion = 0; portion < MostPortions && count == bytes.size(); ++portion)
  {
    count = this->Link->Receive(bytes.data(), bytes.size());
    for (std::size_t i = 0; i < count; ++i)
    {
      FalconReply found;
      if (this->Parser.Take(bytes[i], found) && this->Accept(found, now))
      {
        reply = found;
        isNew = true;
      }
    }
  }
  this->Counts.SkippedBytes = this->Parser.SkippedBytes();
  return isNew;
}
} // namespace palpate
