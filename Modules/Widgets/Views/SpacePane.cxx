#include "SpacePane.h"

#include "CameraAxes.h"
#include "SliceGeometry.h"

#include "vtkCamera.h"

#include <QKeyEvent>
#include <QTabletEvent>

namespace palpate
{
SpacePane::SpacePane(const ViewContents& contents, QWidget* parent)
    : ViewPane("3-D", QColor(170, 170, 170), parent), Pause(new QTimer(this))
{
  this->Pause->setSingleShot(true);
  this->Pause->setInterval(RestTime);
  connect(this->Pause, &QTimer::timeout, this,
          [this]
          {
            this->Space->MovingOff();
            this->RequestFrame();
          });
  this->SetGround(this->Ground);
  this->setObjectName("space");
  this->Show(this->Space, contents);
  this->ShowSlices(false);
  this->SetStyle(this->Style);
  this->Style->AddObserver(vtkInteractorStyleMouseHand::HandMovedEvent, this, &SpacePane::TellHand);
  this->Style->AddObserver(vtkInteractorStyleMouseHand::AimedEvent, this, &SpacePane::TellAim);
  this->Style->AddObserver(vtkInteractorStyleMouseHand::PressedEvent, this, &SpacePane::Pressed);
  this->Style->AddObserver(vtkInteractorStyleMouseHand::DraggedEvent, this, &SpacePane::TellDrag);
  this->Style->AddObserver(vtkInteractorStyleMouseHand::DragEndEvent, this, &SpacePane::DragEnded);
  this->Style->AddObserver(vtkCommand::EndInteractionEvent, this, &SpacePane::TakeCamera);
}

void SpacePane::Stir()
{
  const bool hasEffects = this->Space->GetAntialiasing() || this->Space->GetAmbientOcclusion();
  if (this->AreEffectsWaiting && hasEffects)
  {
    this->Space->MovingOn();
    this->Pause->start();
  }
}

void SpacePane::Settle()
{
  this->Pause->stop();
  this->Space->MovingOff();
  ViewPane::Settle();
}

void SpacePane::SetGround(ViewGround ground)
{
  constexpr int Middle = 128; // of lightness
  this->Ground = ground;
  Lay(ground, this->palette().color(QPalette::Window).lightness() < Middle, this->Renderer());
  this->RequestRender();
}

void SpacePane::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::PaletteChange)
  {
    this->SetGround(this->Ground);
  }
  ViewPane::changeEvent(event);
}

void SpacePane::TakeCamera()
{
  this->IsLed = true;
  Q_EMIT CameraTurned();
}

void SpacePane::ShowAllUnlessLed()
{
  if (!this->IsLed)
  {
    this->ShowAll();
  }
}

void SpacePane::TellHand()
{
  Q_EMIT HandMoved(Vector3(this->Style->GetHandWorld()));
}

void SpacePane::TellAim()
{
  Q_EMIT Aimed(Vector3(this->Style->GetSightFrom()), Vector3(this->Style->GetSightTo()));
  this->ShowCursor();
}

// A pen pushes by its pressure; its position comes as that of a mouse.
bool SpacePane::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::TabletPress || event->type() == QEvent::TabletMove)
  {
    const double pressure = static_cast<QTabletEvent*>(event)->pressure();
    if (pressure > 0.0 && this->Style->GetButtonPushes())
    {
      this->Style->SetPush(pressure);
    }
    event->ignore();
  }
  // A space bar that is held is one press.
  if (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease)
  {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Space && key->isAutoRepeat())
    {
      return true;
    }
  }
  return ViewPane::eventFilter(object, event);
}

// A hand where a press pushes, an arrow where it moves the camera.
void SpacePane::ShowCursor()
{
  this->setCursor(!this->Style->GetHasRest() ? Qt::ArrowCursor
                  : this->Style->IsPressed() ? Qt::ClosedHandCursor
                                             : Qt::PointingHandCursor);
}

void SpacePane::Rest(const Vector3& toolWorld, const Vector3& normalWorld, double mostPush)
{
  this->Style->SetRest(toolWorld.data(), normalWorld.data());
  this->Style->SetMostPush(mostPush);
}

void SpacePane::TellDrag()
{
  Q_EMIT Dragged(Vector3(this->Style->GetDraggedWorld()));
}

void SpacePane::SetDragging(bool isOn, const Vector3& world)
{
  this->Style->SetDraggedWorld(world.data());
  this->Style->SetDragging(isOn);
}

void SpacePane::ShowFields(const std::set<vtkProp*>& fields)
{
  this->ShowOnly(this->Fields, fields);
}

void SpacePane::ShowVolumes(const std::set<vtkProp*>& volumes)
{
  this->ShowOnly(this->Volumes, volumes);
}

void SpacePane::ShowOnly(Props& shown, const std::set<vtkProp*>& props)
{
  const Props next(props.begin(), props.end());
  if (next == shown)
  {
    return;
  }
  for (const auto& prop : shown)
  {
    this->Renderer()->RemoveViewProp(prop);
    this->Unfollow(prop);
  }
  for (vtkProp* prop : props)
  {
    this->Renderer()->AddViewProp(prop);
    this->Follow(prop);
  }
  shown = next;
  this->ShowAllUnlessLed();
  this->RequestRender();
}

void SpacePane::ShowSlices(bool areShown)
{
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    this->Space->SetSliceVisibility(static_cast<int>(orientation), areShown);
  }
  // It would see little from within the volume.
  if (areShown && this->Space->IsCameraInside())
  {
    this->ShowAll();
  }
  this->RequestRender();
}

void SpacePane::SmoothEdges(bool areSmooth)
{
  this->Space->SetAntialiasing(areSmooth);
  this->RequestRender();
}

void SpacePane::ShowOcclusion(bool isShown)
{
  this->Space->SetAmbientOcclusion(isShown);
  this->RequestRender();
}

void SpacePane::ShowToolShadow(bool isShown)
{
  this->Space->SetToolShadow(isShown);
  this->RequestRender();
}

void SpacePane::LookFrom(int side)
{
  this->Space->LookFrom(side);
  this->RequestRender();
  this->TakeCamera();
}

void SpacePane::LookAt(const Vector3& world)
{
  vtkCamera* camera = this->Renderer()->GetActiveCamera();
  const Vector3 eye = world + Vector3(camera->GetPosition()) - Vector3(camera->GetFocalPoint());
  camera->SetFocalPoint(world.data());
  camera->SetPosition(eye.data());
  this->Renderer()->ResetCameraClippingRange();
  this->RequestRender();
  this->TakeCamera();
}

void SpacePane::ShowAll()
{
  this->Space->ResetCamera();
  this->RequestRender();
}

void SpacePane::SetHand(bool isOn, const Vector3& handWorld)
{
  this->Style->SetHandWorld(handWorld.data());
  this->Style->SetHand(isOn);
}

Matrix3 SpacePane::Axes() const
{
  return CameraAxes(this->Renderer()->GetActiveCamera());
}
} // namespace palpate
