#pragma once

#include "vtkCrosshair.h"
#include "vtkImageDisplay.h"
#include "vtkLandmarks.h"
#include "vtkProbeRepresentation.h"
#include "vtkSliceView.h"
#include "vtkSpaceView.h"
#include "vtkSurfaceDisplay.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>

namespace palpate::test
{
/// Three linked slices and a 3D view of one volume, in one off-screen window: axial at the upper
/// left, 3D next to it, coronal and sagittal below.
class FourViews
{
public:
  FourViews(vtkImageData* image, int width, int height)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetAlphaBitPlanes(1);
    this->Window->SetSize(width, height);
    this->Images->SetImage(image);
    double center[3];
    this->Images->GetCenterWorld(center);
    this->Crosshair->SetPositionWorld(center);
    this->AddSlice(vtkSliceView::AXIAL, 0.0, 0.5);
    this->AddSlice(vtkSliceView::CORONAL, 0.0, 0.0);
    this->AddSlice(vtkSliceView::SAGITTAL, 0.5, 0.0);
    this->Link(this->Space, 0.5, 0.5);
    this->Probe->VisibilityOff();
  }

  void AddSurface(vtkSurfaceDisplay* surface)
  {
    this->Space->AddSurface(surface);
    for (vtkSliceView* slice : this->Slices)
    {
      slice->AddSurface(surface);
    }
  }
  void Render() { this->Window->Render(); }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkImageDisplay> Images;
  vtkNew<vtkCrosshair> Crosshair;
  vtkNew<vtkLandmarks> Landmarks;
  vtkNew<vtkProbeRepresentation> Probe;
  std::array<vtkNew<vtkSliceView>, 3> Slices; ///< by orientation
  vtkNew<vtkSpaceView> Space;

private:
  void Link(vtkLinkedView* view, double left, double bottom)
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(left, bottom, left + 0.5, bottom + 0.5);
    this->Window->AddRenderer(renderer);
    view->SetRenderer(renderer);
    view->SetImageDisplay(this->Images);
    view->SetCrosshair(this->Crosshair);
    view->SetLandmarks(this->Landmarks);
    view->SetProbe(this->Probe);
  }
  void AddSlice(int orientation, double left, double bottom)
  {
    vtkSliceView* slice = this->Slices[static_cast<std::size_t>(orientation)];
    slice->SetOrientation(orientation);
    this->Link(slice, left, bottom);
  }
};
} // namespace palpate::test
