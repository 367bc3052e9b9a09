#pragma once

#include "TouchState.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// The start or end of something between two ticks.
struct TouchChange
{
  enum class Kind
  {
    ContactBegins,
    ContactEnds,
    ButtonPressed,
    ButtonReleased,
    Fault,   ///< forces went off
    ForcesOn ///< after a fault
  };

  Kind What = Kind::ContactBegins;
  std::int32_t Structure = -1;         ///< index in the scene, for a contact
  int Button = 0;                      ///< for a button, from 0
  SafetyFault Why = SafetyFault::None; ///< for a fault
  bool WillResume = false;             ///< for a fault: it ends by itself
  std::int64_t Time = 0;               ///< ns of the servo's clock, when the tick began
};

/// Detects changes in a stream of ticks, however rarely it is polled: no contact is too short to be
/// noticed as long as no tick is lost. A change from one structure to another ends one contact and
/// starts one.
class TouchWatch
{
public:
  /// Appends the differences from the previous tick; before the first there is no contact, button
  /// or fault.
  void Take(const TouchState& tick, std::vector<TouchChange>& changes);

private:
  std::int32_t Structure = -1;
  std::uint32_t Buttons = 0;
  SafetyFault Fault = SafetyFault::None;
};
} // namespace palpate
