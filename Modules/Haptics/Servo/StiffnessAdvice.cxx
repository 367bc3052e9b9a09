#include "StiffnessAdvice.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace palpate
{
namespace
{
std::string Rounded(double number)
{
  char text[32];
  const auto end = std::to_chars(text, text + sizeof(text), number, std::chars_format::general, 3);
  return {text, end.ptr};
}

void Lower(StableStiffness& stable, double bound, const char* reason) noexcept
{
  if (bound < stable.Largest)
  {
    stable = {bound, reason};
  }
}
} // namespace

StableStiffness StiffestStable(const DeviceCapabilities& device, double rate,
                               double damping) noexcept
{
  StableStiffness stable{std::numeric_limits<double>::infinity(), ""};
  if (device.Damping > 0.0 && rate > 0.0)
  {
    const double lag = 0.5 / rate + device.Delay;
    Lower(stable, std::max(0.0, device.Damping - damping) / lag,
          "its own damping cannot absorb more of the energy that sampling generates");
  }
  if (device.Friction > 0.0 && device.Resolution > 0.0)
  {
    Lower(stable, 2.0 * device.Friction / device.Resolution,
          "its encoder resolution would cause buzzing");
  }
  if (device.MaximumStiffness > 0.0)
  {
    Lower(stable, device.MaximumStiffness, "more is not known to be stable");
  }
  return stable;
}

std::vector<std::string> StiffnessWarnings(const TouchScene& scene,
                                           const DeviceCapabilities& device, double rate)
{
  std::vector<std::string> warnings;
  double everywhere = 0.0;
  for (const auto& field : scene.Fields)
  {
    everywhere += field->Stiffness();
  }
  for (const TouchStructure& structure : scene.Structures)
  {
    double damping = structure.Law.Damping;
    double rigid = structure.Law.Stiffness;
    double field = everywhere;
    for (const auto& effect : structure.Effects)
    {
      damping += effect->Damping();
      rigid = effect->LargestStiffness(rigid);
      field += effect->Field() != nullptr ? effect->Field()->Stiffness() : 0.0;
    }
    const double own = structure.Model != nullptr ? structure.Model->OwnStiffness(scene.Tool) : 0.0;
    const double handPerWorld = scene.Frame.LengthDevice(Vector3::UnitX()).norm();
    const double contact = own > 0.0 ? own / handPerWorld : rigid;
    damping += own > 0.0 ? structure.Law.Relaxation * contact : 0.0;
    const double stiffness = contact + field / handPerWorld;
    const StableStiffness stable = StiffestStable(device, rate, damping);
    if (stiffness > stable.Largest)
    {
      warnings.push_back("The structure " + structure.Name + " requests " + Rounded(stiffness) +
                         " N/mm; the device " + device.Name + " at " + Rounded(rate) +
                         " Hz is stable up to " + Rounded(stable.Largest) + " N/mm, since " +
                         stable.Reason +
                         ": lower its stiffness or its damping, or it may vibrate.");
    }
    else if (device.Damping > 0.0 && damping > device.Damping)
    {
      warnings.push_back("The structure " + structure.Name + " damps with " + Rounded(damping) +
                         " N s/mm; the mechanism of " + device.Name + " supports " +
                         Rounded(device.Damping) +
                         ": lower its damping or its viscosity, or it may vibrate.");
    }
  }
  return warnings;
}
} // namespace palpate
