#pragma once

#include "AnatomicalView.h"
#include "PalpateInteractionModule.h"
#include "ViewProps.h"

#include "vtkActor2D.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <array>

class vtkTextActor;

namespace palpate
{
/// The patient's directions in a corner of a 3D view: lines to left, posterior and superior with
/// their letters, rotated with the camera.
class PALPATEINTERACTION_EXPORT AxesMarker : public ViewProps
{
public:
  AxesMarker();
  /// For a view of `width` pixels, with `pointPixels` pixels per point.
  void Update(const ViewFrame& frame, int width, double pointPixels);
  /// Of its text, 0 to 1.
  void SetGrey(double grey);

private:
  vtkNew<vtkPolyData> Lines;
  vtkNew<vtkActor2D> Axes;
  std::array<vtkSmartPointer<vtkTextActor>, 3> Letters;
};
} // namespace palpate
