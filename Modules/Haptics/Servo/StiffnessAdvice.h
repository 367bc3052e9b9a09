#pragma once

#include "DeviceCapabilities.h"
#include "TouchScene.h"

#include <string>
#include <vector>

namespace palpate
{
/// The stiffest structure that a device holds stable, and why.
struct StableStiffness
{
  double Largest = 0.0; ///< N/mm; infinite where nothing is known of the device
  const char* Reason = "";
};

/// The least of three bounds; those that need a number which the device does not know are left out.
///
/// - The mechanism's damping b takes up what sampling gives out: b > K (T/2 + t) + |B| for a period
///   T, a delay t and the structure's damping B (Colgate and Schenkel, "Passivity of a class of
///   sampled-data systems", J. Robotic Systems 14, 1997; a delay adds to the half period that
///   holding a force costs). B may come from filtered velocities as long as the filter's gain is at
///   most 1.
/// - Its friction f hides what encoder counts D give out: K <= 2 f / D (Diolaiti et al., "Stability
///   of haptic rendering", IEEE Trans. Robotics 22, 2006).
/// - What its maker or experience says.
///
/// `rate` in Hz, `damping` (B) in N s/mm.
StableStiffness StiffestStable(const DeviceCapabilities& device, double rate,
                               double damping) noexcept;

/// A sentence for every structure that asks for more, or for more viscosity and damping than the
/// mechanism has, to be shown before forces start.
std::vector<std::string> StiffnessWarnings(const TouchScene& scene,
                                           const DeviceCapabilities& device, double rate);
} // namespace palpate
