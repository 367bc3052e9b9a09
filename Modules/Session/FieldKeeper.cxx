#include "FieldKeeper.h"

#include <chrono>

namespace palpate
{
namespace
{
constexpr double Nano = 1e-9;
constexpr auto Period = std::chrono::milliseconds(5);
constexpr double PeriodSeconds = 0.005;
} // namespace

FieldKeeper::FieldKeeper(std::vector<std::shared_ptr<OnDemandField>> fields, Probe probe)
    : Fields(std::move(fields)), Place(std::move(probe)), CoarseBefore(AllCoarseTicks())
{
}

void FieldKeeper::Look(double time)
{
  for (const std::shared_ptr<OnDemandField>& field : this->Fields)
  {
    field->Look({time, this->Place->Latest()}, [time] { return time; });
  }
}

void FieldKeeper::Run(const Clock& clock)
{
  const auto now = [&clock] { return Nano * static_cast<double>(clock.Now()); };
  while (!this->IsOver.load(std::memory_order_relaxed))
  {
    for (const std::shared_ptr<OnDemandField>& field : this->Fields)
    {
      // A place may be as old as the last look when its version is begun.
      field->Look({now(), this->Place->Latest()}, [&now] { return now() + PeriodSeconds; });
    }
    std::this_thread::sleep_for(Period);
  }
}

void FieldKeeper::Start(const Clock& clock)
{
  if (!this->Fields.empty())
  {
    this->Worker = std::thread([this, &clock] { this->Run(clock); });
  }
}

void FieldKeeper::Stop()
{
  this->IsOver = true;
  if (this->Worker.joinable())
  {
    this->Worker.join();
  }
}

std::uint64_t FieldKeeper::CoarseTicks() const
{
  return this->AllCoarseTicks() - this->CoarseBefore;
}

std::uint64_t FieldKeeper::AllCoarseTicks() const
{
  std::uint64_t ticks = 0;
  for (const std::shared_ptr<OnDemandField>& field : this->Fields)
  {
    ticks += field->Counts().CoarseTicks;
  }
  return ticks;
}

std::string FieldKeeper::Problem() const
{
  for (const std::shared_ptr<OnDemandField>& field : this->Fields)
  {
    if (std::string problem = field->Counts().Problem; !problem.empty())
    {
      return problem;
    }
  }
  return {};
}
} // namespace palpate
