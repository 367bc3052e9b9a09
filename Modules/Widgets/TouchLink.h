#pragma once

#include "StudyController.h"
#include "ViewContents.h"
#include "ViewGrid.h"

#include <QObject>

class QKeyEvent;

namespace palpate
{
/// Connects a study's touch to the views: they show tool and force, the mouse over the 3D view is
/// the hand of a simulated device, the device's axes follow the camera, slices follow the probe,
/// Escape stops all force anywhere in the program, and the D key is the drill's pedal, which is
/// also released when another window becomes active.
class TouchLink : public QObject
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  TouchLink(StudyController& study, ViewContents& contents, ViewGrid& views, QObject* parent);

  /// The workspace is shown while touching, and moved by the mouse.
  void ShowWorkspace(bool isShown);
  void MoveWorkspace(bool isMoved);
  /// While clicks place marks, they do not push.
  void LeaveClicks(bool areForMarks);
  /// Whether force is off on purpose: the tool is shown where the hand is, without a notice.
  void ShowHandOnly(bool isOn);
  /// Whether an alarm begins with a sound.
  void SoundAlarms(bool areHeard) { this->AreAlarmsHeard = areHeard; }

Q_SIGNALS:
  /// Escape was pressed: force is off, and modes of the mouse end.
  void Escaped();

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  void PressKey(const QKeyEvent& key, const QObject* receiver);
  void ReleaseKey(const QKeyEvent& key);
  void Begin();
  void ShowReading();
  void ShowDrilled();
  void ShowProbe();
  double ToolDistance() const;
  void ShowNotice();
  void ShowPlace();
  void TellAxes();
  void MoveHand(const Vector3& targetWorld);
  void FindRest(const Vector3& from, const Vector3& to);
  void LeadIn(SlicePane* slice);
  bool FindRestInSlice(const Vector3& point);
  void TakePlane(const SlicePane& slice);
  void AimAt(int structure);
  void Lift();
  void ShowHand();
  void TakeHand();
  void FollowProbe();

  StudyController& Study;
  ViewContents& Contents;
  ViewGrid& Views;
  bool IsWorkspaceShown = false;
  bool IsWorkspaceMoved = false;
  bool AreAlarmsHeard = false;
  bool IsAlarmed = false;
  bool IsPointing = false; // the mouse is the hand
  bool AreClicksForMarks = false;
  bool IsHandOnly = false;
  int AimedAt = -1;                   // the structure that MostPush is for; none before the first
  double MostPush = 0.0;              // mm
  Vector3 Followed = Vector3::Zero(); // the probe, by the slices
  bool IsLedInSlice = false;
  // Of the slice that was last pressed.
  Vector3 SliceRight = Vector3::UnitX();
  Vector3 SliceUp = Vector3::UnitY();
  double SliceReach = 0.0; // mm
  Vector3 SliceRest = Vector3::Zero();
};
} // namespace palpate
