#pragma once

#include <cstdint>

namespace palpate
{
/// What a person wants of what was drilled so far. It goes through the servo, so that it has its
/// place among the cuts and is recorded with its tick.
enum class DrillCommand : std::uint8_t
{
  None,
  EndStroke, ///< what is cut from now on is undone apart
  Undo,
  Redo,
  Reset
};
} // namespace palpate
