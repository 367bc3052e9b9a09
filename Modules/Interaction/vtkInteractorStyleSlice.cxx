#include "vtkInteractorStyleSlice.h"

#include "vtkImageDisplay.h"
#include "vtkSliceView.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

vtkStandardNewMacro(vtkInteractorStyleSlice);

namespace
{
constexpr double WheelZoom = 1.2;   // per notch
constexpr double DragZoom = 3.0;    // the logarithm of a drag over the view's whole height
constexpr double DragWindows = 2.0; // default windows, likewise
constexpr int PageSlices = 10;
} // namespace

void vtkInteractorStyleSlice::AddView(vtkSliceView* view)
{
  this->Views.emplace_back(view);
}

vtkSliceView* vtkInteractorStyleSlice::PokedView()
{
  if (this->Interactor == nullptr)
  {
    return nullptr;
  }
  const int* position = this->Interactor->GetEventPosition();
  this->FindPokedRenderer(position[0], position[1]);
  const auto view = std::find_if(this->Views.begin(), this->Views.end(),
                                 [this](vtkSliceView* candidate)
                                 { return candidate->GetRenderer() == this->CurrentRenderer; });
  return view == this->Views.end() || this->CurrentRenderer == nullptr ? nullptr : view->Get();
}

bool vtkInteractorStyleSlice::StartDrag(int drag)
{
  vtkSliceView* view = this->PokedView();
  if (view == nullptr || this->State != VTKIS_NONE)
  {
    return false;
  }
  this->DraggedView = view;
  this->ActiveDrag = drag;
  std::copy_n(this->Interactor->GetEventPosition(), 2, this->StartPosition);
  this->InvokeEvent(vtkCommand::StartInteractionEvent);
  if (drag == CROSSHAIR_DRAG)
  {
    this->Drag();
  }
  return true;
}

bool vtkInteractorStyleSlice::EndDrag()
{
  if (this->ActiveDrag == NO_DRAG)
  {
    return false;
  }
  const bool isPush = this->ActiveDrag == PUSH_DRAG;
  this->ActiveDrag = NO_DRAG;
  this->DraggedView = nullptr;
  if (isPush)
  {
    this->InvokeEvent(LiftedEvent);
  }
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  return true;
}

void vtkInteractorStyleSlice::Lift()
{
  if (this->ActiveDrag == PUSH_DRAG)
  {
    this->EndDrag();
  }
}

bool vtkInteractorStyleSlice::Aims()
{
  vtkSliceView* view = this->Hand ? this->PokedView() : nullptr;
  if (view == nullptr || this->Interactor->GetControlKey() != 0 ||
      this->Interactor->GetShiftKey() != 0)
  {
    return false;
  }
  const int* pointer = this->Interactor->GetEventPosition();
  view->DisplayToWorld(pointer[0], pointer[1], this->PointerWorld);
  this->IsAccepted = false;
  this->InvokeEvent(AimedEvent);
  return this->IsAccepted;
}

void vtkInteractorStyleSlice::Finish()
{
  this->InvokeEvent(vtkCommand::InteractionEvent);
  this->Interactor->Render();
}

void vtkInteractorStyleSlice::DragWindowLevel(double right, double up)
{
  vtkImageDisplay* display = this->DraggedView->GetImageDisplay();
  if (display != nullptr)
  {
    const int height = std::max(1, this->DraggedView->GetRenderer()->GetSize()[1]);
    const double scale = DragWindows * display->GetChosenWindow() / height;
    display->SetWindowLevel(display->GetWindow() + scale * right, display->GetLevel() - scale * up);
  }
}

void vtkInteractorStyleSlice::Drag()
{
  const int* now = this->Interactor->GetEventPosition();
  const int* last = this->Interactor->GetLastEventPosition();
  const double right = now[0] - last[0];
  const double up = now[1] - last[1];
  switch (this->ActiveDrag)
  {
  case CROSSHAIR_DRAG:
    this->DraggedView->MoveCrosshairTo(now[0], now[1]);
    break;
  case WINDOW_LEVEL_DRAG:
    this->DragWindowLevel(right, up);
    break;
  case PAN_DRAG:
    this->DraggedView->Pan(right, up);
    break;
  case PUSH_DRAG:
    this->DraggedView->DisplayToWorld(now[0], now[1], this->PointerWorld);
    this->InvokeEvent(HandMovedEvent);
    break;
  default:
    const int height = std::max(1, this->DraggedView->GetRenderer()->GetSize()[1]);
    this->DraggedView->Zoom(std::exp(DragZoom * up / height), this->StartPosition[0],
                            this->StartPosition[1]);
    break;
  }
  this->Finish();
}

void vtkInteractorStyleSlice::OnMouseMove()
{
  if (this->ActiveDrag != NO_DRAG)
  {
    this->Drag();
    return;
  }
  if (vtkSliceView* view = this->Interactor->GetShiftKey() != 0 ? this->PokedView() : nullptr)
  {
    const int* now = this->Interactor->GetEventPosition();
    view->MoveCrosshairTo(now[0], now[1]);
    this->Finish();
    return;
  }
  this->Superclass::OnMouseMove();
}

void vtkInteractorStyleSlice::OnLeftButtonDown()
{
  if (this->Aims() && this->StartDrag(PUSH_DRAG))
  {
    this->InvokeEvent(PressedEvent);
    return;
  }
  const bool isOther = this->Interactor->GetControlKey() != 0;
  const bool movesCrosshair = (this->LeftButtonMode == CROSSHAIR) != isOther;
  const bool pans = this->Interactor->GetShiftKey() != 0;
  if (!this->StartDrag(pans ? PAN_DRAG : movesCrosshair ? CROSSHAIR_DRAG : WINDOW_LEVEL_DRAG))
  {
    this->Superclass::OnLeftButtonDown();
  }
}

void vtkInteractorStyleSlice::OnLeftButtonUp()
{
  if (!this->EndDrag())
  {
    this->Superclass::OnLeftButtonUp();
  }
}

void vtkInteractorStyleSlice::OnMiddleButtonDown()
{
  if (!this->StartDrag(PAN_DRAG))
  {
    this->Superclass::OnMiddleButtonDown();
  }
}

void vtkInteractorStyleSlice::OnMiddleButtonUp()
{
  if (!this->EndDrag())
  {
    this->Superclass::OnMiddleButtonUp();
  }
}

void vtkInteractorStyleSlice::OnRightButtonDown()
{
  if (!this->StartDrag(ZOOM_DRAG))
  {
    this->Superclass::OnRightButtonDown();
  }
}

void vtkInteractorStyleSlice::OnRightButtonUp()
{
  if (!this->EndDrag())
  {
    this->Superclass::OnRightButtonUp();
  }
}

bool vtkInteractorStyleSlice::Wheel(int direction)
{
  vtkSliceView* view = this->PokedView();
  if (view == nullptr)
  {
    return false;
  }
  if (this->Interactor->GetControlKey() != 0)
  {
    const int* position = this->Interactor->GetEventPosition();
    view->Zoom(direction > 0 ? WheelZoom : 1.0 / WheelZoom, position[0], position[1]);
  }
  else
  {
    view->Scroll(direction);
  }
  this->Finish();
  return true;
}

void vtkInteractorStyleSlice::OnMouseWheelForward()
{
  if (!this->Wheel(1))
  {
    this->Superclass::OnMouseWheelForward();
  }
}

void vtkInteractorStyleSlice::OnMouseWheelBackward()
{
  if (!this->Wheel(-1))
  {
    this->Superclass::OnMouseWheelBackward();
  }
}

void vtkInteractorStyleSlice::OnKeyPress()
{
  static const std::map<std::string, int> Steps{
      {"Up", 1},    {"Right", 1},          {"Down", -1},
      {"Left", -1}, {"Prior", PageSlices}, {"Next", -PageSlices}};
  const char* key = this->Interactor->GetKeySym();
  const auto step = Steps.find(key == nullptr ? "" : key);
  vtkSliceView* view = this->PokedView();
  if (view != nullptr && step != Steps.end())
  {
    view->Scroll(step->second);
    this->Finish();
    return;
  }
  this->Superclass::OnKeyPress();
}

// VTK's keys reset cameras, end programs and pick; over a slice only r has a meaning.
void vtkInteractorStyleSlice::OnChar()
{
  vtkSliceView* view = this->PokedView();
  if (view == nullptr)
  {
    this->Superclass::OnChar();
    return;
  }
  if (this->Interactor->GetKeyCode() == 'r' || this->Interactor->GetKeyCode() == 'R')
  {
    view->FitToImage();
    this->Finish();
  }
}

void vtkInteractorStyleSlice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Views: " << this->Views.size() << '\n';
  os << indent
     << "LeftButtonMode: " << (this->LeftButtonMode == CROSSHAIR ? "crosshair" : "window and level")
     << '\n';
}
