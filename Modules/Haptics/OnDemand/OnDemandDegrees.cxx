#include "OnDemandDegrees.h"

#include "DegreePlan.h"

#include <algorithm>

namespace palpate
{
namespace
{
std::string ShortOf(std::size_t bytes)
{
  constexpr std::size_t Kilo = 1000;
  return bytes == 0 ? ""
                    : "What is near the tool takes " + std::to_string(bytes / Kilo + 1) +
                          " kB more than its harmonics may.";
}
} // namespace

OnDemandDegrees::OnDemandDegrees(std::vector<std::shared_ptr<OnDemandHarmonics>> structures,
                                 const Settings& settings)
    : All(std::move(structures)), Wanted(settings),
      Ahead(settings.PromisedSpeed, settings.LeastDelay), IsLeaving(All.size(), false)
{
  this->Ahead.Look(ToolPlace());
  this->FirstWay = this->Ahead.Length();
  this->Begin();
}

void OnDemandDegrees::Begin()
{
  this->Ahead = WayAhead(this->Wanted.PromisedSpeed, this->Wanted.LeastDelay);
  for (std::size_t one = 0; one < this->All.size(); ++one)
  {
    if (this->All[one]->IsAtHand())
    {
      this->IsLeaving[one] = !this->All[one]->Drop();
    }
  }
  const std::size_t bytes = this->BytesAtHand();
  const std::lock_guard<std::mutex> lock(this->Shared);
  this->Known = {};
  this->Known.MostBytes = bytes;
}

double OnDemandDegrees::SlowestMaking() const noexcept
{
  double slowest = 0.0;
  for (const std::shared_ptr<OnDemandHarmonics>& one : this->All)
  {
    slowest = std::max(slowest, one->MakingSeconds());
  }
  return slowest;
}

double OnDemandDegrees::AwayFrom(std::size_t one, const Vector3& placeWorld) const
{
  const double away = this->All[one]->BoundsWorld().exteriorDistance(placeWorld);
  return std::max(0.0, away - this->Wanted.ToolRadius);
}

bool OnDemandDegrees::AllAreAtHand(const Vector3& placeWorld) const
{
  const double way = this->Ahead.Length();
  for (std::size_t one = 0; one < this->All.size(); ++one)
  {
    if (this->AwayFrom(one, placeWorld) <= way &&
        (this->IsLeaving[one] || !this->All[one]->IsAtHand()))
    {
      return false;
    }
  }
  return true;
}

std::size_t OnDemandDegrees::BytesAtHand() const
{
  std::size_t bytes = 0;
  for (const std::shared_ptr<OnDemandHarmonics>& one : this->All)
  {
    bytes += one->IsAtHand() ? one->BytesAtHand() : 0;
  }
  return bytes;
}

void OnDemandDegrees::Drop(std::size_t one)
{
  this->IsLeaving[one] = !this->All[one]->Drop();
  if (!this->IsLeaving[one])
  {
    const std::lock_guard<std::mutex> lock(this->Shared);
    ++this->Known.Dropped;
  }
}

// False where there is no room yet, since others are still held.
bool OnDemandDegrees::Bring(std::size_t one, std::string& problem)
{
  if (this->BytesAtHand() + this->All[one]->BytesAtHand() > this->Wanted.Room)
  {
    return false;
  }
  const Status status = this->All[one]->Bring();
  problem = status.IsOk() ? problem : status.Message();
  const std::size_t bytes = this->BytesAtHand();
  const std::lock_guard<std::mutex> lock(this->Shared);
  ++this->Known.Brought;
  this->Known.MostBytes = std::max(this->Known.MostBytes, bytes);
  return true;
}

void OnDemandDegrees::NoteProblem(const std::string& problem)
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  this->Known.Problem = problem;
}

std::uint64_t OnDemandDegrees::CoarseTicks() const noexcept
{
  std::uint64_t ticks = 0;
  for (const std::shared_ptr<OnDemandHarmonics>& one : this->All)
  {
    ticks += one->CoarseTicks();
  }
  return ticks;
}

DegreeCounts OnDemandDegrees::Counts() const
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  return this->Known;
}

bool OnDemandDegrees::Renew(const ToolPlace& place)
{
  if (!place.IsFinite())
  {
    return false;
  }
  this->Ahead.Look(place);
  if (this->AllAreAtHand(place.ProbeWorld))
  {
    this->NoteProblem({});
    return false;
  }
  std::vector<DegreeCandidate> candidates;
  std::size_t promised = 0; // bytes of what a tool as fast as promised may come to
  for (std::size_t one = 0; one < this->All.size(); ++one)
  {
    candidates.push_back({this->AwayFrom(one, place.ProbeWorld), this->All[one]->BytesAtHand(),
                          this->All[one]->IsAtHand()});
    promised += candidates.back().Away <= this->FirstWay ? candidates.back().Bytes : 0;
  }
  const DegreeChoice choice =
      ChooseDegrees(candidates, {this->Ahead.Length(), 0.5 * this->FirstWay, this->Wanted.Room},
                    [&](std::size_t one) { return this->All[one]->HeightOver(place.ProbeWorld); });
  std::string problem = ShortOf(promised > this->Wanted.Room ? promised - this->Wanted.Room : 0);
  for (const std::size_t one : choice.Drop)
  {
    this->Drop(one);
  }
  for (std::size_t one = 0; one < this->All.size(); ++one)
  {
    const bool isDropped =
        std::find(choice.Drop.begin(), choice.Drop.end(), one) != choice.Drop.end();
    if (this->IsLeaving[one] && !isDropped)
    {
      const Status status = this->All[one]->Bring();
      problem = status.IsOk() ? problem : status.Message();
      this->IsLeaving[one] = false;
    }
  }
  bool isBrought = false;
  for (const std::size_t one : choice.Bring)
  {
    isBrought = this->Bring(one, problem) || isBrought;
  }
  this->NoteProblem(problem);
  return isBrought;
}
} // namespace palpate
