#pragma once

#include "SliceGeometry.h"
#include "ViewContents.h"
#include "ViewPane.h"

#include "vtkInteractorStyleSlice.h"
#include "vtkSliceView.h"

#include <QPointF>

#include <optional>
#include <set>

namespace palpate
{
/// One slice view of a window.
class SlicePane : public ViewPane
{
  Q_OBJECT

public:
  /// Shows `contents`, which outlive it.
  SlicePane(SliceOrientation orientation, const ViewContents& contents, QWidget* parent);

  vtkSliceView* View() const { return this->Slice; }
  /// See vtkInteractorStyleSlice::LeftButtonModes.
  void SetLeftButtonMode(int mode) { this->Style->SetLeftButtonMode(mode); }
  void SetNeurological(bool isNeurological);
  void FitToImage();
  /// Shows the contours of these sub-voxel volumes, and no others.
  void ShowFields(const std::set<vtkVolume*>& fields);
  /// See vtkSliceView::ShowPoint.
  void ShowPlace(const Vector3& pointWorld);

  /// Whether a press may lead a tool: then it is Aimed, and pressed if AcceptPress was called.
  void SetHand(bool isOn) { this->Style->SetHand(isOn); }
  void AcceptPress() { this->Style->AcceptPress(); }
  /// A hand as the cursor where a press would lead the tool.
  void ShowHand(bool isHand)
  {
    this->setCursor(isHand               ? Qt::PointingHandCursor
                    : this->AreStrokesOn ? Qt::CrossCursor
                                         : Qt::ArrowCursor);
  }
  ///@{
  /// A pixel to the right and up, as vectors (world, mm).
  Vector3 PixelRight() const { return this->PointAt(1.0, 0.0) - this->PointAt(0.0, 0.0); }
  Vector3 PixelUp() const { return this->PointAt(0.0, 1.0) - this->PointAt(0.0, 0.0); }
  ///@}
  void Lift() { this->Style->Lift(); }
  /// Whether the left button draws strokes instead: then the style does not get it.
  void SetStrokes(bool areOn);

Q_SIGNALS:
  ///@{
  /// A stroke (world, mm), which may be a click; and whether Ctrl was held where it began.
  void StrokeBegun(const Vector3& pointWorld, bool hasControl);
  void StrokeMoved(const Vector3& pointWorld);
  void StrokeEnded(bool hadControl);
  ///@}
  /// The pointer may lead a tool from here (world, mm).
  void Aimed(const Vector3& pointWorld);
  void Pressed();
  void HandMoved(const Vector3& pointWorld);
  void Lifted();
  /// The point under the pointer (world, mm).
  void PointedAt(const Vector3& pointWorld);
  void ClickedAt(const Vector3& pointWorld);
  /// See Tapped.
  void TappedAt(const Vector3& pointWorld);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  bool TakeStroke(QEvent* event);
  void ChooseSlice(int number);
  Vector3 PointAt(double x, double y) const;
  void TellPoint();
  void TellAim();
  void TellHand();

  vtkNew<vtkSliceView> Slice;
  vtkNew<vtkInteractorStyleSlice> Style;
  std::set<vtkSmartPointer<vtkVolume>> Fields;
  std::optional<QPointF> Pointer; // over the canvas
  bool AreStrokesOn = false;
  bool IsStroke = false;
  bool HadControl = false;
};
} // namespace palpate
