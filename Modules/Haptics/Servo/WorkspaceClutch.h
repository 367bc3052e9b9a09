#pragma once

#include "WorkspaceFrame.h"

namespace palpate
{
/// What moves a workspace by hand: while the clutch is held the tool stays where it is and nothing
/// should be felt; let go, the hand leads it on from there, wherever it is now.
class WorkspaceClutch
{
public:
  bool IsHeld() const noexcept { return this->Held; }
  /// Where the tool stays, mm.
  const Vector3& PlaceWorld() const noexcept { return this->Place; }

  void Hold(const Vector3& probeWorld) noexcept
  {
    this->Held = true;
    this->Place = probeWorld;
  }
  /// The frame, moved so that a hand that is at `handDevice` (mm) has the tool where it stayed.
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
