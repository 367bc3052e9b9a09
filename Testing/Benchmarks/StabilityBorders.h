#pragma once

#include <functional>
#include <string>
#include <vector>

namespace palpate::bench
{
/// One structure, device and hand, and up to which stiffness (N/mm) it was stable.
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

/// Measures all; some minutes. `report` is told how many of how many are done.
std::vector<StabilityBorder> MeasureStability(const std::function<void(int, int)>& report);

/// A list of objects, one a border.
std::string ToJson(const std::vector<StabilityBorder>& borders);
} // namespace palpate::bench
