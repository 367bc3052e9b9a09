#pragma once

#include "StudyController.h"
#include "ViewContents.h"
#include "ViewGrid.h"

#include <QAction>
#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace palpate
{
/// A closed line around a place, in a plane of two unit vectors; mm.
std::vector<Vector3> CircleAround(const Vector3& center, const Vector3& right, const Vector3& up,
                                  double radius);

/// The mode in which a drag at the surface of a structure pulls or pushes it, in slices and in 3-D,
/// and a button of the device at the place that its tool touches. The study moves the surface; the
/// views show it, and a ring as wide as the next pull.
class CorrectionLink : public QObject
{
  Q_OBJECT

public:
  /// Keeps the addresses. `selected` are structures, of which the mode begins with the first one
  /// that can be corrected, or else with the first of the study; `contact` is the place of the
  /// tool's contact (world, mm).
  CorrectionLink(StudyController& study, ViewContents& contents, ViewGrid& views,
                 std::function<std::vector<int>()> selected, std::function<Vector3()> contact,
                 QObject* parent);

  /// Switches the mode.
  QAction* Mode() const { return this->Pulling; }
  /// Grips the surface where the tool touches it, and lets it go again.
  QAction* GripTool() const { return this->Gripping; }
  /// Where the tool touches, world mm.
  Vector3 TouchedPlace() const { return this->Contact(); }
  /// Whether drags and the grip pull while the mode is on; otherwise they are another tool's.
  void LetPull(bool arePulls);
  const PullWidth& Width() const { return this->Next; }
  void SetWidth(const PullWidth& width);
  /// Adds a step.
  void Do(const CorrectionStep& step);
  /// Corrects another structure, or none, from its start.
  void Choose(int id);

Q_SIGNALS:
  void WidthChanged();

private:
  // What is held by the pointer or the hand.
  struct Grip
  {
    Vector3 PlaceWorld = Vector3::Zero(); ///< of the surface
    Vector3 Normal = Vector3::UnitZ();
    Vector3 StartWorld = Vector3::Zero(); ///< of the pointer or the hand
    ViewPane* Pane = nullptr;             ///< null: the hand's
    double StartOffset = 0.0;             ///< in 3-D, on the normal, mm
    double StartHeight = 0.0;             ///< in 3-D, pixels
    SurfacePull Pull = {};

    /// Where it is led to.
    Vector3 Place() const
    {
      return this->Pull.TargetWorld
                 ? *this->Pull.TargetWorld
                 : Vector3(this->PlaceWorld + this->Pull.Displacement * this->Normal);
    }
  };

  void FollowSlice(SlicePane* slice);
  void FollowSpace();
  int FirstToCorrect() const;
  void ShowMode(bool isOn);
  void ShowSurface();
  std::optional<std::size_t> PointInSlice(const SlicePane& slice, double x, double y);
  std::optional<std::size_t> PointInSpace(double x, double y, Vector3& pickedWorld);
  bool Hold(std::size_t point, const Vector3& startWorld, ViewPane* pane);
  void PullInSpace(double x, double y);
  double OffsetInSpace(double x, double y) const;
  void PullTo(const Vector3& pointWorld);
  void Preview();
  void EndPull();
  void GiveUp();
  void TurnWheel(ViewPane* pane, double notches);
  void ShowRing(std::optional<std::size_t> point, const Vector3& right, const Vector3& up);
  void HideRing() { this->ShowRing(std::nullopt, this->RingRight, this->RingUp); }
  bool IsPulling() const { return this->Pulling->isChecked() && this->ArePulls; }
  bool IsInHand() const { return this->Held && this->Held->Pane == nullptr; }
  void FollowHand();
  void GripWhereTouched();

  StudyController& Study;
  ViewContents& Contents;
  ViewGrid& Views;
  std::function<std::vector<int>()> Selected;
  std::function<Vector3()> Contact;
  QAction* Pulling;
  QAction* Gripping;
  PullWidth Next;
  std::optional<Grip> Held;
  std::optional<std::size_t> Pointed; ///< the point of the surface under the pointer
  Vector3 RingRight = Vector3::UnitX();
  Vector3 RingUp = Vector3::UnitY();
  bool WasPressed = false; ///< the device's button
  bool ArePulls = true;
};
} // namespace palpate
