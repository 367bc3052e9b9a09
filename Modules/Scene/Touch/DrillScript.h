#pragma once

#include "DrillCommand.h"
#include "PalpateSceneModule.h"

#include <filesystem>
#include <vector>

namespace palpate
{
/// What somebody who drills does with pedal and buttons, over time.
struct DrillAction
{
  enum class Kind
  {
    Start, ///< the pedal is pressed
    Stop,  ///< and let go, which ends a stroke
    EndStroke,
    Undo,
    Redo,
    Reset
  };
  double Time = 0.0; ///< s
  Kind Do = Kind::Start;
};

/// Reads { "format": "palpate-drill", "actions": [ { "time_s": 0.5, "do": "start" }, ... ] }, in
/// the order of time; "do" is start, stop, end-stroke, undo, redo or reset. Throws InputError.
PALPATESCENE_EXPORT std::vector<DrillAction> ReadDrillScript(const std::filesystem::path& path);

/// The command of an action; None of the pedal's.
PALPATESCENE_EXPORT DrillCommand CommandOf(DrillAction::Kind kind);
} // namespace palpate
