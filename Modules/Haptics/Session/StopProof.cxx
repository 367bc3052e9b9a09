#include "StopProof.h"

#include "Vector3.h"

namespace palpate
{
namespace
{
double ForceOf(const TouchState& tick) noexcept
{
  return Vector3(tick.ForceDevice).norm();
}

bool IsStill(const TouchState& tick) noexcept
{
  const bool hasArrived = tick.WasTaken || tick.State == DeviceState::Error;
  return hasArrived && ForceOf(tick) == 0.0 && Vector3(tick.TorqueDevice).norm() == 0.0;
}
} // namespace

StopProof StopProof::Of(const std::vector<TouchState>& ticks, std::int64_t stopped) noexcept
{
  StopProof proof;
  int after = 0;
  proof.StaysOff = true;
  for (const TouchState& tick : ticks)
  {
    if (tick.Tick.Started < stopped)
    {
      proof.ForceBefore = tick.WasTaken ? ForceOf(tick) : 0.0;
      continue;
    }
    ++after;
    const bool isStill = IsStill(tick);
    if (proof.Ticks == 0)
    {
      proof.Ticks = isStill ? after : 0;
      proof.Delay = tick.Tick.Started - stopped;
      continue;
    }
    ++proof.TicksAfter;
    proof.StaysOff = proof.StaysOff && isStill;
  }
  proof.StaysOff = proof.StaysOff && proof.Ticks > 0;
  return proof;
}

std::optional<std::int64_t> StopProof::FindStop(const std::vector<TouchState>& ticks) noexcept
{
  bool hadForce = false;
  for (const TouchState& tick : ticks)
  {
    if (hadForce && (tick.Safety.Fault != SafetyFault::None || tick.IsClutched))
    {
      return tick.Tick.Started;
    }
    hadForce = tick.WasTaken && ForceOf(tick) >= LeastForce;
  }
  return std::nullopt;
}
} // namespace palpate
