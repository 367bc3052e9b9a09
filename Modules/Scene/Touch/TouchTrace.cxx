#include "TouchTrace.h"

#include "Units.h"
#include "Vector3.h"

namespace palpate
{
namespace
{
void Join(TouchStretch& stretch, const TouchStretch& next)
{
  stretch.Force.Join(next.Force);
  stretch.Torque.Join(next.Torque);
  stretch.Depth.Join(next.Depth);
  stretch.Period.Join(next.Period);
  stretch.Computation.Join(next.Computation);
}

LeastAndMost Alone(double value)
{
  return {static_cast<float>(value), static_cast<float>(value)};
}
} // namespace

TouchStretch StretchOf(const TouchState& state, std::int64_t start, std::int64_t last)
{
  TouchStretch tick;
  tick.Time = SecondsPerNanosecond * static_cast<double>(state.Tick.Started - start);
  tick.Force = Alone(Vector3(state.ForceDevice).norm());
  tick.Torque = Alone(Vector3(state.TorqueDevice).norm());
  tick.Depth = Alone(state.Structure < 0 ? 0.0 : state.Depth);
  tick.Period = Alone(MicrosecondsPerNanosecond * static_cast<double>(state.Tick.Started - last));
  return tick;
}

void TouchTrace::Add(const TouchStretch& tick)
{
  this->LastTime = tick.Time;
  if (this->List.empty())
  {
    this->List.reserve(MostStretches);
    this->All = tick;
  }
  Join(this->All, tick);
  if (!this->List.empty() && this->TicksInLast < this->Length)
  {
    Join(this->List.back(), tick);
    ++this->TicksInLast;
    return;
  }
  if (this->List.size() == MostStretches)
  {
    this->Halve();
  }
  this->List.push_back(tick);
  this->TicksInLast = 1;
}

void TouchTrace::Halve()
{
  for (std::size_t i = 0; i < this->List.size() / 2; ++i)
  {
    this->List[i] = this->List[2 * i];
    Join(this->List[i], this->List[2 * i + 1]);
  }
  this->List.resize(this->List.size() / 2);
  this->Length *= 2;
}
} // namespace palpate
