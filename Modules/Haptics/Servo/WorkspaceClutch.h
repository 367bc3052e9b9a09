#pragma once

#include "WorkspaceFrame.h"

namespace palpate
{
/// Moves a workspace by hand: while the clutch is held the tool stays in place and touch should be
/// off; after release, the hand moves it on from there, wherever the hand is by then.
class WorkspaceClutch
{
public:
  bool IsHeld() const noexcept { return this->Held; }
  /// Position of the held tool, mm.
  const Vector3& PlaceWorld() const noexcept { return this->Place; }

  void Hold(const Vector3& probeWorld) noexcept
  {
    this->Held = true;
    this->Place = probeWorld;
  }
  /// The frame, moved so that a hand at `handDevice` (mm) has the tool at its held position.
  WorkspaceFrame Release(const WorkspaceFrame& frame, const Vector3& handDevice) noexcept
  {
    this->Held = false;
    WorkspaceFrame moved = frame;
    moved.CenterWorld += this->Place - frame.ToWorld(handDevice);
    return moved;
  }

private:
  bool Held = false;
  Vector3 Place = Vector3::Zero();
};
} // namespace palpate
