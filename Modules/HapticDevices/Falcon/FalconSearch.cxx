#include "FalconSearch.h"

#include "FalconBoot.h"
#include "FalconExchange.h"
#include "FalconFirmware.h"

namespace palpate
{
namespace
{
// Whether all encoders are homed, judged by several replies.
bool IsHomed(FalconLink& link, Clock& clock)
{
  constexpr std::int64_t Round = 5'000'000; // ns
  constexpr int MostRounds = 30;
  constexpr int Enough = 5; // replies
  FalconExchange exchange(link);
  exchange.Restart(clock.Now());
  FalconRequest request;
  request.IsHoming = true;
  request.Light = FalconLight::Red;
  FalconReply reply;
  int replies = 0;
  for (int n = 0; n < MostRounds && replies < Enough &&
                  exchange.Send(request, clock.Now()) != FalconDelivery::Gone;
       ++n)
  {
    clock.WaitUntil(clock.Now() + Round);
    replies += exchange.Receive(clock.Now(), reply) ? 1 : 0;
  }
  return reply.Homed == FalconReply::AllHomed;
}

// Queries an open link. Messages about loading firmware are those of FalconFirmware and FalconBoot.
FoundDevice Ask(FalconLink& link, Clock& clock, const std::string& firmwarePath)
{
  const Status answer = link.Control(FtdiRequest::LatencyTimer(1));
  if (!answer.IsOk())
  {
    return {"", false, answer.Message()};
  }
  const Status running = FalconBoot(link, clock).Run("");
  if (running.IsOk())
  {
    return {"", true,
            IsHomed(link, clock) ? "its firmware runs, and it is homed"
                                 : "its firmware runs; it has to be homed"};
  }
  if (firmwarePath.empty())
  {
    return {"", false, running.Message()};
  }
  FalconFirmware firmware;
  const Status readable = FalconFirmware::Read(firmwarePath, firmware);
  return {"", readable.IsOk(),
          readable.IsOk() ? "no firmware runs (or its power supply is missing); " + firmwarePath +
                                " is loaded when it is used, then it has to be homed"
                          : readable.Message()};
}
} // namespace

Status FindFalcons(FalconFinder& finder, Clock& clock, const std::string& firmwarePath,
                   std::vector<FoundDevice>& found)
{
  std::vector<FalconListing> listings;
  Status status = finder.List(listings);
  if (!status.IsOk())
  {
    return status;
  }
  if (listings.empty())
  {
    return Status::Failure("There is no Falcon on USB: plug in its cable and its power supply.");
  }
  for (const FalconListing& listing : listings)
  {
    FoundDevice device;
    device.Details = listing.Obstacle;
    if (listing.Obstacle.empty())
    {
      std::unique_ptr<FalconLink> link;
      Status opened = finder.MakeLink(listing.BusPath, link);
      opened = opened.IsOk() ? link->Open() : opened;
      device = opened.IsOk() ? Ask(*link, clock, firmwarePath)
                             : FoundDevice{"", false, opened.Message()};
    }
    device.Argument = "device=" + listing.BusPath;
    device.Details += listing.Serial.empty() ? "" : " (serial number " + listing.Serial + ")";
    found.push_back(device);
  }
  return Status::Success();
}
} // namespace palpate
