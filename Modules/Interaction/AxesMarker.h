#pragma once

#include "AnatomicalView.h"
#include "PalpateInteractionModule.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>

class vtkActor2D;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

namespace palpate
{
/// The patient's directions in a corner of a 3D view: lines to left, posterior and superior with
/// their letters, rotated with the camera.
class PALPATEINTERACTION_EXPORT AxesMarker
{
public:
  AxesMarker();
  ~AxesMarker();
  AxesMarker(const AxesMarker&) = delete;
  AxesMarker& operator=(const AxesMarker&) = delete;

  void AddTo(vtkRenderer* renderer) const;
  void RemoveFrom(vtkRenderer* renderer) const;
  void SetVisible(bool isVisible);
  /// For a view of `width` pixels, with `pointPixels` pixels per point.
  void Update(const ViewFrame& frame, int width, double pointPixels);

private:
  vtkNew<vtkPolyData> Lines;
  vtkNew<vtkActor2D> Axes;
  std::array<vtkSmartPointer<vtkTextActor>, 3> Letters;
};
} // namespace palpate
