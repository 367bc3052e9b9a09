#include "SceneKeeper.h"

#include <chrono>

namespace palpate
{
namespace
{
constexpr double Nano = 1e-9;
constexpr auto Period = std::chrono::milliseconds(5);
constexpr double PeriodSeconds = 0.005;
} // namespace

SceneKeeper::SceneKeeper(OnDemandParts parts, Probe probe)
    : Parts(std::move(parts)), Place(std::move(probe)), CoarseBefore(AllCoarseTicks())
{
  if (this->Parts.Degrees != nullptr)
  {
    this->Parts.Degrees->Begin();
  }
}

void SceneKeeper::LookAll(const PlaceNow& place, const SecondsNow& begun, const SecondsNow& made)
{
  for (const std::shared_ptr<OnDemandField>& field : this->Parts.Fields)
  {
    field->Look({begun(), place()}, made);
  }
  if (this->Parts.Degrees != nullptr)
  {
    this->Parts.Degrees->Look({begun(), place()}, made);
  }
}

void SceneKeeper::LookAt(const Vector3& placeWorld, double time)
{
  const auto now = [time] { return time; };
  this->LookAll([&placeWorld] { return placeWorld; }, now, now);
}

void SceneKeeper::Look(double time)
{
  if (!this->Parts.IsEmpty())
  {
    this->LookAt(this->Place->Latest(), time);
  }
}

void SceneKeeper::Run(const Clock& clock)
{
  const auto now = [&clock] { return Nano * static_cast<double>(clock.Now()); };
  // A place may be as old as the last look when what it wants is begun.
  const auto made = [&now] { return now() + PeriodSeconds; };
  while (!this->IsOver.load(std::memory_order_relaxed))
  {
    this->LookAll([this] { return Vector3(this->Place->Latest()); }, now, made);
    std::this_thread::sleep_for(Period);
  }
}

void SceneKeeper::Start(const Clock& clock)
{
  if (!this->Parts.IsEmpty())
  {
    if (this->Parts.Degrees != nullptr)
    {
      this->Parts.Degrees->Expect(this->Parts.Degrees->SlowestMaking() + PeriodSeconds);
    }
    this->Worker = std::thread([this, &clock] { this->Run(clock); });
  }
}

void SceneKeeper::Stop()
{
  this->IsOver = true;
  if (this->Worker.joinable())
  {
    this->Worker.join();
  }
}

std::uint64_t SceneKeeper::CoarseTicks() const
{
  return this->AllCoarseTicks() - this->CoarseBefore;
}

std::uint64_t SceneKeeper::AllCoarseTicks() const
{
  std::uint64_t ticks = this->Parts.Degrees != nullptr ? this->Parts.Degrees->CoarseTicks() : 0;
  for (const std::shared_ptr<OnDemandField>& field : this->Parts.Fields)
  {
    ticks += field->Counts().CoarseTicks;
  }
  return ticks;
}

std::string SceneKeeper::Problem() const
{
  for (const std::shared_ptr<OnDemandField>& field : this->Parts.Fields)
  {
    if (std::string problem = field->Counts().Problem; !problem.empty())
    {
      return problem;
    }
  }
  return this->Parts.Degrees != nullptr ? this->Parts.Degrees->Counts().Problem : std::string();
}
} // namespace palpate
