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
                    : this->HasStrokes() ? Qt::CrossCursor
                                         : Qt::ArrowCursor);
  }
  ///@{
  /// A pixel to the right and up, as vectors (world, mm).
  Vector3 PixelRight() const { return this->PointAt(1.0, 0.0) - this->PointAt(0.0, 0.0); }
  Vector3 PixelUp() const { return this->PointAt(0.0, 1.0) - this->PointAt(0.0, 0.0); }
  ///@}
  void Lift() { this->Style->Lift(); }
  void SetStrokes(bool areOn) override;
  /// Of a place on the canvas (world, mm).
  Vector3 PointAt(double x, double y) const;

Q_SIGNALS:
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

private:
  void ChooseSlice(int number);
  void TellPoint();
  void TellAim();
  void TellHand();

  vtkNew<vtkSliceView> Slice;
  vtkNew<vtkInteractorStyleSlice> Style;
  std::set<vtkSmartPointer<vtkVolume>> Fields;
  std::optional<QPointF> Pointer; // over the canvas
};
} // namespace palpate
