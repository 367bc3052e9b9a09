#include "TouchResultCollector.h"

#include "ResidentMemory.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double Nano = 1e-9;
constexpr double SettlingTime = 1.0; // s, until memory has settled
} // namespace

TouchResultCollector::TouchResultCollector(TouchResult& result, std::size_t structures)
    : Result(result)
{
  result.TouchedSeconds.resize(structures);
}

void TouchResultCollector::Add(const TouchState& state, float microseconds)
{
  if (this->Result.Ticks++ == 0)
  {
    this->Start = state.Tick.Scheduled;
    this->Last = state.Tick.Started;
  }
  const double passed = Nano * static_cast<double>(state.Tick.Started - this->Last);
  this->Trace(state, microseconds);
  this->Last = state.Tick.Started;
  if (state.Structure >= 0)
  {
    this->Result.TouchedSeconds[static_cast<std::size_t>(state.Structure)] += passed;
  }
  this->Result.LeastEnergy = std::min(this->Result.LeastEnergy, state.Safety.Energy);
  if (this->Result.Fault == SafetyFault::None)
  {
    this->Result.Fault = state.Safety.Fault;
  }
}

void TouchResultCollector::Trace(const TouchState& state, float microseconds)
{
  TouchStretch tick = StretchOf(state, this->Start, this->Last);
  tick.Computation = {microseconds, microseconds};
  this->Result.Trace.Add(tick);
  if (this->Result.MebibytesAtStart == 0.0 && tick.Time >= SettlingTime)
  {
    this->Result.MebibytesAtStart = ResidentMebibytes();
  }
}

void TouchResultCollector::Close()
{
  this->Result.MebibytesAtEnd = ResidentMebibytes();
  if (this->Result.MebibytesAtStart == 0.0)
  {
    this->Result.MebibytesAtStart = this->Result.MebibytesAtEnd;
  }
}
} // namespace palpate
