#include "vtkInteractorStyleMouseHand.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

vtkStandardNewMacro(vtkInteractorStyleMouseHand);

namespace
{
constexpr double ShareOfHeight = 0.02; // of a view, that a notch moves along the line of sight
constexpr double PushPerNotch = 0.05;
constexpr double FirstPush = 0.1;
constexpr int GrowthInterval = 20;      // ms
constexpr double GrowthPerTimer = 0.01; // the strongest push after 1.8 s

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

void vtkInteractorStyleMouseHand::SetRest(const double position[3], const double normal[3])
{
  TakeNumbers(position, this->Rest);
  TakeNumbers(normal, this->RestNormal);
  this->HasRest = true;
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

// Asks where the tool would rest under the pointer.
void vtkInteractorStyleMouseHand::Aim()
{
  const int* pointer = this->Interactor->GetEventPosition();
  for (int end = 0; end < 2; ++end)
  {
    double world[4];
    this->ComputeDisplayToWorld(pointer[0], pointer[1], end, world);
    std::copy_n(world, 3, end == 0 ? this->SightFrom : this->SightTo);
  }
  this->HasRest = false;
  this->InvokeEvent(AimedEvent);
}

// The hand from the rest by the push.
void vtkInteractorStyleMouseHand::TellHand()
{
  double along[3];
  vtkMath::Subtract(this->SightTo, this->SightFrom, along);
  vtkMath::Normalize(along);
  double world[3];
  for (int a = 0; a < 3; ++a)
  {
    const double direction = this->PushAlongSight ? along[a] : -this->RestNormal[a];
    world[a] = this->Rest[a] + this->Push * this->MostPush * direction;
  }
  this->SetHandWorld(world);
  this->InvokeEvent(HandMovedEvent);
}

void vtkInteractorStyleMouseHand::MoveHandToPointer()
{
  if (!this->FindRenderer())
  {
    return;
  }
  this->Aim();
  if (this->HasRest)
  {
    this->TellHand();
    return;
  }
  if (this->Presses)
  {
    return; // off the edge of the surface: the push waits until the pointer comes back
  }
  double world[3];
  this->WorldAtPointer(this->HandWorld, this->Interactor->GetEventPosition(), world);
  this->SetHandWorld(world);
  this->InvokeEvent(HandMovedEvent);
}

void vtkInteractorStyleMouseHand::Press(double push)
{
  if (!this->Presses)
  {
    this->TellHand(); // at the rest
    this->Presses = true;
    this->InvokeEvent(PressedEvent);
  }
  this->Push = std::min(push, 1.0);
  this->TellHand();
}

void vtkInteractorStyleMouseHand::SetPush(double push)
{
  if (!(push > 0.0))
  {
    this->Lift();
  }
  else if (this->HasRest && !this->IsForCamera())
  {
    this->Grows = false;
    this->Press(push);
  }
}

void vtkInteractorStyleMouseHand::Lift()
{
  if (this->Growing != 0 && this->Interactor != nullptr)
  {
    this->Interactor->DestroyTimer(this->Growing);
  }
  this->Growing = 0;
  if (this->IsButtonDown)
  {
    this->IsButtonDown = false;
    this->ReleaseFocus();
  }
  if (!this->Presses)
  {
    return;
  }
  this->Presses = false;
  this->Push = 0.0;
  this->TellHand();
  this->InvokeEvent(LiftedEvent);
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
  // The view's height there, in mm.
  double display[3];
  this->ComputeWorldToDisplay(world[0], world[1], world[2], display);
  double low[4];
  double high[4];
  const int* size = this->CurrentRenderer->GetSize();
  this->ComputeDisplayToWorld(display[0], 0.0, display[2], low);
  this->ComputeDisplayToWorld(display[0], size[1], display[2], high);
  const double notch = ShareOfHeight * std::sqrt(vtkMath::Distance2BetweenPoints(low, high));
  for (int a = 0; a < 3; ++a)
  {
    world[a] += notches * notch * sight[a];
  }
}

bool vtkInteractorStyleMouseHand::MoveDeeper(double notches)
{
  if (this->IsForCamera() || !this->FindRenderer())
  {
    return false;
  }
  if (!this->Dragging && this->HasRest)
  {
    this->SetPush(this->Push + PushPerNotch * notches);
    return true;
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
  else if (!this->FindRenderer())
  {
    return;
  }
  else if (this->AimsAtSurface())
  {
    if (this->ButtonPushes)
    {
      this->BeginPush();
    }
  }
  else
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
  if (this->IsButtonDown)
  {
    this->Lift();
    return;
  }
  this->Superclass::OnLeftButtonUp();
}

void vtkInteractorStyleMouseHand::BeginPush()
{
  this->GrabFocus(this->EventCallbackCommand);
  this->IsButtonDown = true;
  this->Grows = this->Push == 0.0; // a pen has set it before
  this->Growing = this->NeedsTimer ? this->Interactor->CreateRepeatingTimer(GrowthInterval) : 0;
  this->Press(std::max(this->Push, FirstPush));
}

// An arrow key moves the pointer by a hundredth of the view's height, from its middle at first.
bool vtkInteractorStyleMouseHand::MovePointer(const char* key)
{
  const std::string name = key != nullptr ? key : "";
  const int right = name == "Right" ? 1 : name == "Left" ? -1 : 0;
  const int up = name == "Up" ? 1 : name == "Down" ? -1 : 0;
  if ((right == 0 && up == 0) || this->Interactor->GetRenderWindow() == nullptr)
  {
    return false;
  }
  const int* size = this->Interactor->GetRenderWindow()->GetSize();
  const int* pointer = this->Interactor->GetEventPosition();
  const bool isNowhere = pointer[0] == 0 && pointer[1] == 0;
  const int step = std::max(1, size[1] / 100);
  const int x = isNowhere ? size[0] / 2 : pointer[0] + right * step;
  const int y = isNowhere ? size[1] / 2 : pointer[1] + up * step;
  this->Interactor->SetEventPosition(std::clamp(x, 1, std::max(1, size[0] - 1)),
                                     std::clamp(y, 1, std::max(1, size[1] - 1)));
  this->MoveHandToPointer();
  return true;
}

void vtkInteractorStyleMouseHand::OnKeyPress()
{
  const char* key = this->Interactor->GetKeySym();
  const bool isHand = this->Hand && !this->Dragging && !this->IsForCamera();
  if (isHand && this->MovePointer(key))
  {
    return;
  }
  const bool isSpace = key != nullptr && std::strcmp(key, "space") == 0;
  if (isHand && isSpace && !this->IsButtonDown && this->FindRenderer() && this->AimsAtSurface())
  {
    this->BeginPush();
    return;
  }
  this->Superclass::OnKeyPress();
}

void vtkInteractorStyleMouseHand::OnKeyRelease()
{
  const char* key = this->Interactor->GetKeySym();
  if (this->IsButtonDown && key != nullptr && std::strcmp(key, "space") == 0)
  {
    this->Lift();
    return;
  }
  this->Superclass::OnKeyRelease();
}

bool vtkInteractorStyleMouseHand::AimsAtSurface()
{
  if (this->IsForCamera())
  {
    return false;
  }
  this->Aim();
  return this->HasRest;
}

void vtkInteractorStyleMouseHand::OnLeave()
{
  this->Lift();
  this->Superclass::OnLeave();
}

// A push that is held grows.
void vtkInteractorStyleMouseHand::OnTimer()
{
  if (this->IsButtonDown && this->Grows && this->HasRest)
  {
    this->Press(this->Push + GrowthPerTimer);
  }
  this->Superclass::OnTimer();
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
  os << indent << "Push: " << this->Push << " of " << this->MostPush << " mm\n";
  os << indent << "PushAlongSight: " << (this->PushAlongSight ? "on" : "off") << '\n';
}
