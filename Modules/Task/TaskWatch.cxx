#include "TaskWatch.h"

#include "Units.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double TraceStep = 0.2;          // mm
constexpr std::size_t LongestTrace = 8000; // points, 1.6 m
} // namespace

TaskWatch::TaskWatch(const TaskSettings& task, bool hasForce, double toolRadius)
    : MostSeconds(task.MostSeconds), MostForce(task.MostForce), HasForce(hasForce),
      ToolRadius(toolRadius)
{
}

Vector3 TaskWatch::TipWorld(const TouchState& tick) const
{
  const Vector3 probe(tick.ProbeWorld);
  const Vector3 proxy(tick.ProxyWorld);
  if (!this->HasForce || tick.Structure < 0)
  {
    return probe;
  }
  return proxy + this->ToolRadius * (probe - proxy).stableNormalized();
}

void TaskWatch::MeasureForce(const TouchState& tick, double passed)
{
  const bool touches = tick.Structure >= 0;
  const double force = Vector3(tick.ForceWorld).norm();
  this->Conduct.Contacts += touches && !this->Touches ? 1 : 0;
  this->Touches = touches;
  this->Conduct.PeakForce = std::max(this->Conduct.PeakForce, force);
  if (touches)
  {
    this->Conduct.TouchedSeconds += passed;
    this->ForceSeconds += force * passed;
    this->Conduct.DeepestMillimeters = std::max(this->Conduct.DeepestMillimeters, tick.Depth);
  }
  this->Conduct.MeanForce =
      this->Conduct.TouchedSeconds > 0.0 ? this->ForceSeconds / this->Conduct.TouchedSeconds : 0.0;
}

void TaskWatch::Take(const TouchState& tick)
{
  if (this->IsOver() || !tick.HasSample)
  {
    return;
  }
  const std::int64_t now = tick.Tick.Started;
  const Vector3 tool(this->HasForce ? tick.ProxyWorld : tick.ProbeWorld);
  this->First = this->HasTicked ? this->First : now;
  const double passed =
      this->HasTicked ? SecondsPerNanosecond * static_cast<double>(now - this->Last) : 0.0;
  this->Conduct.PathMillimeters += this->HasTicked ? (tool - this->LastTool).norm() : 0.0;
  this->HasTicked = true;
  this->Last = now;
  this->LastTool = tool;
  this->Conduct.Seconds = SecondsPerNanosecond * static_cast<double>(now - this->First);
  this->MeasureForce(tick, passed);
  if (this->Keeps && this->Kept.size() < LongestTrace)
  {
    const Vector3 tip = this->TipWorld(tick);
    if (this->Kept.empty() || (tip - this->Kept.back()).norm() >= TraceStep)
    {
      this->Kept.push_back(tip);
    }
  }
  if (this->MostForce > 0.0 && this->Conduct.PeakForce > this->MostForce)
  {
    this->Conduct.End = TaskEnd::Force;
  }
  else if (this->MostSeconds > 0.0 && this->Conduct.Seconds >= this->MostSeconds)
  {
    this->Conduct.End = TaskEnd::Time;
  }
}
} // namespace palpate
