#pragma once

#include <cstdint>

namespace palpate
{
/// A user's command on the drilled material. It passes through the servo, so that it has its place
/// among the cuts and is recorded with its tick.
enum class DrillCommand : std::uint8_t
{
  None,
  EndStroke, ///< further cuts become a new stroke
  Undo,
  Redo,
  Reset
};
} // namespace palpate
