#include "IgtlTouchState.h"

namespace palpate
{
std::optional<IgtlTouch> IgtlTouchOf(const TouchState& state) noexcept
{
  if (!state.HasSample || state.State != DeviceState::Ready)
  {
    return std::nullopt;
  }
  const SafetyFault fault = state.Safety.Fault;
  return IgtlTouch{state.ProbeWorld,
                   state.ProxyWorld,
                   state.ForceWorld,
                   state.Structure,
                   fault == SafetyFault::None ? "" : Describe(fault),
                   state.Tick.Number + 1};
}
} // namespace palpate
