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

void vtkInteractorStyleMouseHand::SetHandWorld(const double position[3])
{
  if (std::all_of(position, position + 3, [](double value) { return std::isfinite(value); }))
  {
    std::copy_n(position, 3, this->HandWorld);
  }
}

bool vtkInteractorStyleMouseHand::IsForCamera()
{
  return !this->Hand || this->Interactor->GetControlKey() != 0 ||
         this->Interactor->GetShiftKey() != 0;
}

bool vtkInteractorStyleMouseHand::FindRenderer()
{
  const int* position = this->Interactor->GetEventPosition();
  this->FindPokedRenderer(position[0], position[1]);
  return this->CurrentRenderer != nullptr;
}

void vtkInteractorStyleMouseHand::MoveHandToPointer()
{
  if (!this->FindRenderer())
  {
    return;
  }
  double display[3];
  this->ComputeWorldToDisplay(this->HandWorld[0], this->HandWorld[1], this->HandWorld[2], display);
  const int* position = this->Interactor->GetEventPosition();
  double world[4];
  this->ComputeDisplayToWorld(position[0], position[1], display[2], world);
  this->SetHandWorld(world);
  this->InvokeEvent(HandMovedEvent);
}

bool vtkInteractorStyleMouseHand::MoveHandDeeper(double notches)
{
  if (this->IsForCamera() || !this->FindRenderer())
  {
    return false;
  }
  vtkCamera* camera = this->CurrentRenderer->GetActiveCamera();
  double sight[3];
  camera->GetDirectionOfProjection(sight);
  if (camera->GetParallelProjection() == 0)
  {
    // Through the hand, which stays where it is seen.
    vtkMath::Subtract(this->HandWorld, camera->GetPosition(), sight);
    vtkMath::Normalize(sight);
  }
  double world[3];
  for (int a = 0; a < 3; ++a)
  {
    world[a] = this->HandWorld[a] + notches * this->NotchMillimeters * sight[a];
  }
  this->SetHandWorld(world);
  this->InvokeEvent(HandMovedEvent);
  return true;
}

void vtkInteractorStyleMouseHand::OnMouseMove()
{
  if (this->State == VTKIS_NONE && !this->IsForCamera())
  {
    this->MoveHandToPointer();
    return;
  }
  this->Superclass::OnMouseMove();
}

void vtkInteractorStyleMouseHand::OnLeftButtonDown()
{
  if (!this->Hand)
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

void vtkInteractorStyleMouseHand::OnMouseWheelForward()
{
  if (!this->MoveHandDeeper(1.0))
  {
    this->Superclass::OnMouseWheelForward();
  }
}

void vtkInteractorStyleMouseHand::OnMouseWheelBackward()
{
  if (!this->MoveHandDeeper(-1.0))
  {
    this->Superclass::OnMouseWheelBackward();
  }
}

// VTK's other letters pick, end programs and change how everything is drawn.
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
  os << indent << "NotchMillimeters: " << this->NotchMillimeters << '\n';
}
