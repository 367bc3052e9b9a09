#pragma once

#include "TouchCues.h"

#include <cstdint>

namespace palpate
{
/// What the two motors of a game controller turn, of 65535: the slow, heavy one tells how hard one
/// pushes, the fast, light one texture, how hard the material is, and the knock of a contact.
struct ControllerRumble
{
  std::uint16_t Slow = 0;
  std::uint16_t Fast = 0;

  static ControllerRumble Of(const TouchCue& cue) noexcept;
  bool IsStill() const noexcept { return this->Slow == 0 && this->Fast == 0; }
};
} // namespace palpate
