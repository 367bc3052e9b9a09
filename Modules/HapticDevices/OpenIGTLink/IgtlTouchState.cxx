#include "IgtlTouchState.h"

namespace palpate
{
IgtlTouch IgtlTouchOf(const TouchState& state) noexcept
{
  const SafetyFault fault = state.Safety.Fault;
  return {state.ProbeWorld,
          state.ProxyWorld,
          state.ForceWorld,
          state.Structure,
          fault == SafetyFault::None ? "" : Describe(fault),
          state.Tick.Number + 1};
}
} // namespace palpate
