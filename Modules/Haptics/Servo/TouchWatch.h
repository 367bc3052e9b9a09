#pragma once

#include "TouchState.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// Something that began or ended from one tick to the next.
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
  std::int32_t Structure = -1;         ///< of the scene's, of a contact
  int Button = 0;                      ///< of a button, from 0
  SafetyFault Why = SafetyFault::None; ///< of a fault
  std::int64_t Time = 0;               ///< ns of the servo's clock, when the tick began
};

/// Finds what changes in a stream of ticks, however rarely somebody looks: no touch is too short to
/// be noticed as long as no tick is lost. A hand that goes from one structure to another ends one
/// contact and begins one.
class TouchWatch
{
public:
  /// Appends what is different from the tick before; before the first, nothing is touched, pressed
  /// or wrong.
  void Take(const TouchState& tick, std::vector<TouchChange>& changes);

private:
  std::int32_t Structure = -1;
  std::uint32_t Buttons = 0;
  SafetyFault Fault = SafetyFault::None;
};
} // namespace palpate
