#pragma once

#include "HeldOrgan.h"
#include "StudyController.h"
#include "StudyMatch.h"
#include "ViewContents.h"
#include "ViewGrid.h"

#include <QAction>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace palpate
{
/// The mode in which an organ is held, by the mouse or by the tool, and brought onto another one;
/// let go, it is matched. Both are displayed as surfaces.
class MatchingLink : public QObject
{
  Q_OBJECT

public:
  /// Of a device: holds the organ while it is pressed in the mode.
  static constexpr int HoldButton = 1;

  /// Keeps the addresses.
  MatchingLink(StudyController& study, ViewContents& contents, ViewGrid& views, QObject* parent);

  /// Switches the mode.
  QAction* Mode() const { return this->Matching; }
  /// Holds the organ at the tool, or lets it go.
  QAction* HoldTool() const { return this->Holding; }
  const HeldOrgan& Organ() const { return this->Held; }
  const MatchChoice& Choice() const { return this->Chosen; }
  /// Another choice puts the organ back.
  void Choose(const MatchChoice& choice);
  ///@{ What happens to the organ when it is held and let go.
  const HoldRules& Rules() const { return this->Held.Rules(); }
  void SetRules(const HoldRules& rules) { this->Held.SetRules(rules); }
  ///@}
  /// Puts the organ back where it was.
  void PutBack();
  /// See WriteMatch; an undo step.
  void Keep(const std::filesystem::path& file);

Q_SIGNALS:
  void Changed(); ///< the organ's pose or phase, or the choice

private:
  void FollowSlice(SlicePane* slice);
  void FollowSpace(SpacePane* space);
  void ShowMode(bool isOn);
  void ShowDragging();
  void Take();
  void FollowSurfaces();
  void BeginStroke(const Vector3& point, bool turns);
  void MoveStroke(const SlicePane& slice, const Vector3& point);
  void TakeDrag(const Vector3& world);
  void HoldAtTool(bool isHeld);
  void FollowTouch();
  void Release();
  void Advance();
  void Show();
  vtkPolyData* SurfaceOf(int id) const;

  StudyController& Study;
  ViewContents& Contents;
  ViewGrid& Views;
  QAction* Matching;
  QAction* Holding;
  HeldOrgan Held;
  MatchChoice Chosen;
  vtkSmartPointer<vtkPolyData> Moving; // where they were taken
  vtkSmartPointer<vtkPolyData> Fixed;
  Vector3 Last = Vector3::Zero(); // of the pointer, world, mm
  bool IsTurning = false;
  bool IsButtonDown = false;
  QTimer Frames;
  QElapsedTimer Since;
};
} // namespace palpate
