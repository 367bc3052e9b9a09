#pragma once

#include "DrillCommand.h"
#include "PalpateSceneModule.h"

#include <filesystem>
#include <vector>

namespace palpate
{
/// A scripted action with the drill's pedal and buttons.
struct DrillAction
{
  enum class Kind
  {
    Start, ///< press the pedal
    Stop,  ///< release it, which ends a stroke
    EndStroke,
    Undo,
    Redo,
    Reset
  };
  double Time = 0.0; ///< s
  Kind Do = Kind::Start;
};

/// Reads { "format": "palpate-drill", "actions": [ { "time_s": 0.5, "do": "start" }, ... ] },
/// sorted by time; "do" is start, stop, end-stroke, undo, redo or reset. Throws InputError.
PALPATESCENE_EXPORT std::vector<DrillAction> ReadDrillScript(const std::filesystem::path& path);

/// The editor's command for an action; None for the pedal.
PALPATESCENE_EXPORT DrillCommand CommandOf(DrillAction::Kind kind);
} // namespace palpate
