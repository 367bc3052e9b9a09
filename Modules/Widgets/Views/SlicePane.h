#pragma once

#include "SliceGeometry.h"
#include "ViewContents.h"
#include "ViewPane.h"

#include "vtkInteractorStyleSlice.h"
#include "vtkSliceView.h"

#include <QPointF>

#include <optional>

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
  /// See vtkSliceView::ShowPoint.
  void ShowPlace(const Vector3& pointWorld);

Q_SIGNALS:
  /// The point under the pointer (world, mm).
  void PointedAt(const Vector3& pointWorld);
  void ClickedAt(const Vector3& pointWorld);
  /// See Tapped.
  void TappedAt(const Vector3& pointWorld);

private:
  void ChooseSlice(int number);
  Vector3 PointAt(double x, double y) const;
  void TellPoint();

  vtkNew<vtkSliceView> Slice;
  vtkNew<vtkInteractorStyleSlice> Style;
  std::optional<QPointF> Pointer; // over the canvas
};
} // namespace palpate
