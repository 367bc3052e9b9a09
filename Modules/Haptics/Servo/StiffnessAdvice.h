#pragma once

#include "DeviceCapabilities.h"
#include "TouchScene.h"

#include <string>
#include <vector>

namespace palpate
{
/// The largest stiffness that a device renders stably, and why.
struct StableStiffness
{
  double Largest = 0.0; ///< N/mm; infinite if nothing is known about the device
  const char* Reason = "";
};

/// The smallest of three bounds; those that need an unknown property of the device are omitted.
///
/// - The mechanism's damping b absorbs the energy that sampling generates: b > K (T/2 + t) + |B|
///   for a period T, a delay t and the structure's damping B (Colgate and Schenkel, "Passivity of a
///   class of sampled-data systems", J. Robotic Systems 14, 1997; a delay adds to the half period
///   due to the hold). B may use filtered velocities if the filter's gain is at most 1.
/// - Its friction f exceeds the effect of the encoder resolution D: K <= 2 f / D (Diolaiti et al.,
///   "Stability of haptic rendering", IEEE Trans. Robotics 22, 2006).
/// - The limit given by its manufacturer or experience.
///
/// `rate` in Hz, `damping` (B) in N s/mm.
StableStiffness StiffestStable(const DeviceCapabilities& device, double rate,
                               double damping) noexcept;

/// A warning for every structure that exceeds this, or has more viscosity and damping than the
/// mechanism, to be shown before forces start.
std::vector<std::string> StiffnessWarnings(const TouchScene& scene,
                                           const DeviceCapabilities& device, double rate);
} // namespace palpate
