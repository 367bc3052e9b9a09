#include "SafetyText.h"

namespace palpate
{
std::string SafetyText(const TouchState& state)
{
  const SafetyReport& safety = state.Safety;
  if (safety.Fault != SafetyFault::None)
  {
    return Describe(safety.Fault, safety.WillResume);
  }
  if (state.State == DeviceState::Homing)
  {
    return "The device is homing: move it slowly through its whole workspace.";
  }
  if (!safety.IsArmed)
  {
    return std::string("Forces are off: the device is ") + NameOf(state.State) + ".";
  }
  std::string text = Describe(SafetyFault::None);
  text += state.IsBuried
              ? " The tool is inside a structure, which is felt once the tool has left it."
              : "";
  text += safety.IsRamping ? " They are being faded in." : "";
  text += safety.IsLimited ? " They are limited to the device's maximum." : "";
  text += safety.IsDamping ? " They are damped, since the contact generated energy." : "";
  text += safety.IsSlewing ? " Their rate of change is limited." : "";
  return text;
}
} // namespace palpate
