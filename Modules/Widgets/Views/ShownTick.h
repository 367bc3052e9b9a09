#pragma once

#include "TouchState.h"

#include "vtkProbeRepresentation.h"

namespace palpate
{
/// Whether and how a tick is told to whoever looks.
struct TickLook
{
  bool IsAtHand = false; ///< the tool is drawn where the hand is
  bool IsTold = true;    ///< force and contact are shown
};

/// Shows the pose, force and contact of a tick that has a sample, in colours that say what the
/// force is.
void ShowTick(const TouchState& state, const TickLook& look, vtkProbeRepresentation& probe);
} // namespace palpate
