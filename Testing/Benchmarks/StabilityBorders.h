#pragma once

#include <functional>
#include <string>
#include <vector>

namespace palpate::bench
{
/// One structure, device and hand, and the largest stable stiffness (N/mm).
struct StabilityBorder
{
  std::string Sweep;       ///< "sampling", "counts", "hands"
  std::string Kind;        ///< of structure
  std::string Hand;        ///< "soft", "usual", "firm"
  double Rate;             ///< Hz
  double Delay;            ///< s
  double MechanismDamping; ///< N s/mm
  double Damping;          ///< N s/mm, of the structure
  double Friction;         ///< N, of the mechanism
  double Count;            ///< mm, of the encoders
  double Claimed;          ///< by StiffestStable
  double WithoutEnergy;    ///< no energy given out
  double WithoutVibration; ///< no limit cycle
  double WithSafety;       ///< no limit cycle with the whole safety chain; 0 where not measured
};

/// Measures all; some minutes. `report` receives the number done and the total.
std::vector<StabilityBorder> MeasureStability(const std::function<void(int, int)>& report);

/// A list of objects, one per limit.
std::string ToJson(const std::vector<StabilityBorder>& borders);
} // namespace palpate::bench
