#include "SafetyText.h"

namespace palpate
{
std::string SafetyText(const TouchState& state)
{
  const SafetyReport& safety = state.Safety;
  if (safety.Fault != SafetyFault::None)
  {
    return Describe(safety.Fault);
  }
  if (state.State == DeviceState::Homing)
  {
    return "The device looks for its zero: move it slowly through all of its workspace.";
  }
  if (!safety.IsArmed)
  {
    return std::string("Forces are off: the device is ") + NameOf(state.State) + ".";
  }
  std::string text = Describe(SafetyFault::None);
  text += safety.IsRamping ? " They are being faded in." : "";
  text += safety.IsLimited ? " They are cut to the largest that the device can give." : "";
  text += safety.IsDamping ? " They are damped, since the contact gave out energy." : "";
  text += safety.IsSlewing ? " They follow a sudden change a little later." : "";
  return text;
}
} // namespace palpate
