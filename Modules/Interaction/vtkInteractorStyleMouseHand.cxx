#include "vtkInteractorStyleMouseHand.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkInteractorStyleMouseHand);

namespace
{
void TakeNumbers(const double from[3], double to[3])
{
  if (std::all_of(from, from + 3, [](double value) { return std::isfinite(value); }))
  {
    std::copy_n(from, 3, to);
  }
}
} // namespace

void vtkInteractorStyleMouseHand::SetHandWorld(const double position[3])
{
  TakeNumbers(position, this->HandWorld);
}

void vtkInteractorStyleMouseHand::SetDraggedWorld(const double position[3])
{
  TakeNumbers(position, this->DraggedWorld);
}

bool vtkInteractorStyleMouseHand::IsForCamera()
{
  return (!this->Hand && !this->Dragging) || this->Interactor->GetControlKey() != 0 ||
         this->Interactor->GetShiftKey() != 0;
}

bool vtkInteractorStyleMouseHand::FindRenderer()
{
  const int* position = this->Interactor->GetEventPosition();
  this->FindPokedRenderer(position[0], position[1]);
  return this->CurrentRenderer != nullptr;
}

// In the plane through a point, parallel to the screen.
void vtkInteractorStyleMouseHand::WorldAtPointer(const double depthOf[3], const int pointer[2],
                                                 double world[3])
{
  double display[3];
  this->ComputeWorldToDisplay(depthOf[0], depthOf[1], depthOf[2], display);
  double found[4];
  this->ComputeDisplayToWorld(pointer[0], pointer[1], display[2], found);
  std::copy_n(found, 3, world);
}

void vtkInteractorStyleMouseHand::MoveHandToPointer()
{
  if (!this->FindRenderer())
  {
    return;
  }
  double world[3];
  this->WorldAtPointer(this->HandWorld, this->Interactor->GetEventPosition(), world);
  this->SetHandWorld(world);
  this->InvokeEvent(HandMovedEvent);
}

void vtkInteractorStyleMouseHand::DragToPointer()
{
  if (!this->FindRenderer())
  {
    return;
  }
  double from[3];
  double to[3];
  this->WorldAtPointer(this->DraggedWorld, this->Interactor->GetLastEventPosition(), from);
  this->WorldAtPointer(this->DraggedWorld, this->Interactor->GetEventPosition(), to);
  double world[3];
  for (int a = 0; a < 3; ++a)
  {
    world[a] = this->DraggedWorld[a] + to[a] - from[a];
  }
  this->SetDraggedWorld(world);
  this->InvokeEvent(DraggedEvent);
}

void vtkInteractorStyleMouseHand::Deepen(double notches, double world[3])
{
  vtkCamera* camera = this->CurrentRenderer->GetActiveCamera();
  double sight[3];
  camera->GetDirectionOfProjection(sight);
  if (camera->GetParallelProjection() == 0)
  {
    // Along the line of sight through the point, which keeps its position on the screen.
    vtkMath::Subtract(world, camera->GetPosition(), sight);
    vtkMath::Normalize(sight);
  }
  for (int a = 0; a < 3; ++a)
  {
    world[a] += notches * this->NotchMillimeters * sight[a];
  }
}

bool vtkInteractorStyleMouseHand::MoveDeeper(double notches)
{
  if (this->IsForCamera() || !this->FindRenderer())
  {
    return false;
  }
  this->Deepen(notches, this->Dragging ? this->DraggedWorld : this->HandWorld);
  if (this->Dragging)
  {
    this->InvokeEvent(DraggedEvent);
  }
  else
  {
    this->InvokeEvent(HandMovedEvent);
  }
  return true;
}

void vtkInteractorStyleMouseHand::OnMouseMove()
{
  if (this->IsDragged)
  {
    this->DragToPointer();
  }
  else if (this->State == VTKIS_NONE && this->Dragging)
  {
    return;
  }
  else if (this->State == VTKIS_NONE && !this->IsForCamera())
  {
    this->MoveHandToPointer();
  }
  else
  {
    this->Superclass::OnMouseMove();
  }
}

void vtkInteractorStyleMouseHand::OnLeftButtonDown()
{
  if (this->Dragging && !this->IsForCamera())
  {
    this->GrabFocus(this->EventCallbackCommand);
    this->IsDragged = true;
  }
  else if (!this->Hand && !this->Dragging)
  {
    this->Superclass::OnLeftButtonDown();
  }
  else if (this->IsForCamera() && this->FindRenderer())
  {
    this->GrabFocus(this->EventCallbackCommand);
    if (this->Interactor->GetShiftKey() != 0)
    {
      this->StartPan();
    }
    else
    {
      this->StartRotate();
    }
  }
}

void vtkInteractorStyleMouseHand::OnLeftButtonUp()
{
  if (this->IsDragged)
  {
    this->IsDragged = false;
    this->ReleaseFocus();
    this->InvokeEvent(DragEndEvent);
    return;
  }
  this->Superclass::OnLeftButtonUp();
}

void vtkInteractorStyleMouseHand::OnMouseWheelForward()
{
  if (!this->MoveDeeper(1.0))
  {
    this->Superclass::OnMouseWheelForward();
  }
}

void vtkInteractorStyleMouseHand::OnMouseWheelBackward()
{
  if (!this->MoveDeeper(-1.0))
  {
    this->Superclass::OnMouseWheelBackward();
  }
}

// VTK's other keys pick, end programs and change the representation of all actors.
void vtkInteractorStyleMouseHand::OnChar()
{
  const char key = this->Interactor->GetKeyCode();
  if (key == 'r' || key == 'R')
  {
    this->Superclass::OnChar();
  }
}

void vtkInteractorStyleMouseHand::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Hand: " << (this->Hand ? "on" : "off") << '\n';
  os << indent << "HandWorld: " << this->HandWorld[0] << ", " << this->HandWorld[1] << ", "
     << this->HandWorld[2] << '\n';
  os << indent << "Dragging: " << (this->Dragging ? "on" : "off") << '\n';
  os << indent << "DraggedWorld: " << this->DraggedWorld[0] << ", " << this->DraggedWorld[1] << ", "
     << this->DraggedWorld[2] << '\n';
  os << indent << "NotchMillimeters: " << this->NotchMillimeters << '\n';
}
