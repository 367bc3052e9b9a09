#include "ControllerRumble.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
std::uint16_t Power(double part) noexcept
{
  return static_cast<std::uint16_t>(std::lround(65535.0 * std::clamp(part, 0.0, 1.0)));
}
} // namespace

// Motors do not turn below about a tenth of their power: the smallest push is above it.
ControllerRumble ControllerRumble::Of(const TouchCue& cue) noexcept
{
  ControllerRumble rumble;
  rumble.Slow = Power(cue.Push > 0.0 ? 0.12 + 0.88 * cue.Push : 0.0);
  const double fast = std::max({cue.Texture, cue.Knock, 0.5 * cue.Push * cue.Hardness});
  rumble.Fast = Power(fast);
  return rumble;
}
} // namespace palpate
