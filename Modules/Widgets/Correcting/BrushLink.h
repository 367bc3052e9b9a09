#pragma once

#include "CorrectionLink.h"
#include "StudyBrush.h"

#include <QAction>
#include <QList>
#include <QObject>

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// What a drag does in the mode *Push and pull*.
enum class CorrectionTool
{
  Pull,
  Paint,
  Erase
};

/// The brush of the mode *Push and pull*: a disc in slices and a ball at the surface, by the
/// pointer or at the place that the device's tool touches, and what copies and fills slices. What
/// is painted is drawn at once; the study corrects the mask.
class BrushLink : public QObject
{
  Q_OBJECT

public:
  static constexpr double LeastRadius = 0.5;    ///< mm
  static constexpr double LargestRadius = 50.0; ///< mm

  /// Keeps the addresses. `pulls` is the mode.
  BrushLink(StudyController& study, ViewContents& contents, ViewGrid& views, CorrectionLink& pulls,
            QObject* parent);

  CorrectionTool Tool() const { return this->Chosen; }
  /// Ends a stroke that is led.
  void SetTool(CorrectionTool tool);
  double Radius() const { return this->Size; } ///< mm
  void SetRadius(double radius);
  bool KeepsToEdges() const { return this->IsToEdges; }
  /// A hand then also feels the edges of the volume while it has a brush.
  void SetKeepsToEdges(bool isOn);

  /// Paint and erase, and those of slices.
  QList<QAction*> Actions() const { return this->Brushes + this->OfSlices; }
  /// Copies to the next and to the previous slice, and fills between slices.
  const QList<QAction*>& SliceActions() const { return this->OfSlices; }

Q_SIGNALS:
  /// Tool or radius.
  void Changed();

private:
  void MakeActions();
  void FollowSlice(SlicePane* slice);
  void FollowSpace();
  void FollowHand();
  void GripByHand();
  void FollowEdges();
  Vector3 PlaceOfTool() const;
  bool IsOn() const;
  bool IsInHand() const { return this->Brush.IsBegun() && this->Leading == nullptr; }
  std::optional<Vector3> PointInSpace(double x, double y) const;
  void Begin(const Vector3& placeWorld, const std::optional<Vector3>& normal, bool isOther,
             ViewPane* pane);
  void Move(const Vector3& placeWorld);
  void End();
  void GiveUp();
  void ShowRing(const Vector3& placeWorld, const Vector3& right, const Vector3& up);
  void ShowStrokes();
  void ForgetDone();
  SlicePane* PaneOfSlices() const;
  void CopySlice(int direction);
  void FillBetween();

  // A stroke that the mask has not yet.
  struct Pending
  {
    vtkSmartPointer<vtkPolyData> Outline;
    bool Erases = false;
  };

  StudyController& Study;
  ViewContents& Contents;
  ViewGrid& Views;
  CorrectionLink& Pulls;
  CorrectionTool Chosen = CorrectionTool::Pull;
  double Size = 5.0;
  bool IsToEdges = false;
  std::string EdgeProblem; ///< that was reported last
  QList<QAction*> Brushes;
  QList<QAction*> OfSlices;
  StudyBrush Brush;
  ViewPane* Leading = nullptr;  ///< of the stroke; null: the hand
  SlicePane* Pointed = nullptr; ///< over which the pointer was last
  Vector3 RingWorld = Vector3::Zero();
  Vector3 RingRight = Vector3::UnitX();
  Vector3 RingUp = Vector3::UnitY();
  bool HasRing = false;
  bool WasPressed = false; ///< the device's button
  std::vector<Pending> Strokes;
};
} // namespace palpate
