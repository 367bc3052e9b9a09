#include "vtkInteractorStyleHaptic.h"

#include "CameraAxes.h"
#include "FacetContactModel.h"
#include "InputError.h"
#include "OpenBuiltInDevice.h"
#include "ProbeInSpace.h"
#include "ServoThread.h"
#include "SimulatedDevice.h"
#include "SteadyClock.h"
#include "TouchWatch.h"
#include "TriangleMesh.h"
#include "WorkspaceClutch.h"
#include "vtkProbeRepresentation.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkInteractorStyleHaptic);

namespace
{
constexpr unsigned long PollInterval = 16; // ms
constexpr double Notch = 2.0;              // mm in depth, so that what is away is soon reached
} // namespace

struct vtkInteractorStyleHaptic::Live
{
  std::vector<palpate::TouchStructure> Structures;
  palpate::SteadyClock Clock;
  std::unique_ptr<palpate::HapticDevice> Device; // before the thread that uses it
  std::unique_ptr<palpate::ServoThread> Thread;
  palpate::WorkspaceFrame Frame;
  palpate::TouchWatch Watch;
  palpate::TouchState Newest;
  std::vector<palpate::TouchChange> Changes;
  palpate::WorkspaceClutch Clutch;
  int Timer = 0;
  vtkNew<vtkProbeRepresentation> Probe;
  palpate::ProbeInSpace Drawn;
  vtkWeakPointer<vtkRenderer> DrawnIn;
};

vtkInteractorStyleHaptic::vtkInteractorStyleHaptic() : Inner(std::make_unique<Live>())
{
  this->SetDeviceName("simulated");
  this->Inner->Probe->VisibilityOff();
  this->SetNotchMillimeters(Notch);
  this->AddObserver(HandMovedEvent, this, &vtkInteractorStyleHaptic::TakeHand);
}

vtkInteractorStyleHaptic::~vtkInteractorStyleHaptic()
{
  this->StopTouch();
  this->SetDeviceName(nullptr);
}

vtkRenderer* vtkInteractorStyleHaptic::Led()
{
  vtkRenderWindow* window =
      this->Interactor != nullptr ? this->Interactor->GetRenderWindow() : nullptr;
  if (this->DefaultRenderer != nullptr || window == nullptr)
  {
    return this->DefaultRenderer;
  }
  return window->GetRenderers()->GetFirstRenderer();
}

int vtkInteractorStyleHaptic::AddSurface(vtkPolyData* surface, double stiffness)
{
  palpate::TouchStructure structure;
  structure.Name = "surface " + std::to_string(this->GetNumberOfStructures());
  structure.Law.Stiffness = stiffness;
  try
  {
    const palpate::TriangleMesh mesh = palpate::TrianglesOf(surface, structure.Name);
    const palpate::Status status =
        palpate::FacetContactModel::Make(mesh.PointsWorld, mesh.Triangles, structure.Model);
    if (status.IsOk())
    {
      return this->AddStructure(structure);
    }
    vtkErrorMacro(<< status.Message());
  }
  catch (const palpate::InputError& error)
  {
    vtkErrorMacro(<< error.what());
  }
  return -1;
}

int vtkInteractorStyleHaptic::AddStructure(const palpate::TouchStructure& structure)
{
  palpate::TouchScene alone;
  alone.Structures.push_back(structure);
  const palpate::Status status = alone.Check();
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return -1;
  }
  this->Inner->Structures.push_back(structure);
  if (this->IsTouching() && !this->Publish())
  {
    this->Inner->Structures.pop_back();
    return -1;
  }
  return this->GetNumberOfStructures() - 1;
}

void vtkInteractorStyleHaptic::RemoveAllStructures()
{
  this->Inner->Structures.clear();
  if (this->IsTouching())
  {
    this->Publish();
  }
}

int vtkInteractorStyleHaptic::GetNumberOfStructures()
{
  return static_cast<int>(this->Inner->Structures.size());
}

// Hands the servo what there is to feel; nothing while the clutch is held.
bool vtkInteractorStyleHaptic::Publish()
{
  Live& inner = *this->Inner;
  auto scene = std::make_shared<palpate::TouchScene>();
  scene->Tool = palpate::ToolShape::Sphere(this->ToolRadius);
  scene->Frame = inner.Frame.ForDevice();
  if (!inner.Clutch.IsHeld())
  {
    scene->Structures = inner.Structures;
  }
  const palpate::Status status = inner.Thread->Loop().Publish(std::move(scene));
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
  }
  return status.IsOk();
}

bool vtkInteractorStyleHaptic::StartTouch()
{
  this->StopTouch();
  std::unique_ptr<palpate::HapticDevice> device;
  const std::string name = this->DeviceName != nullptr ? this->DeviceName : "";
  const palpate::Status status = palpate::OpenBuiltInDevice(name, this->Inner->Clock, device);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return false;
  }
  return this->StartTouch(std::move(device));
}

bool vtkInteractorStyleHaptic::StartTouch(std::unique_ptr<palpate::HapticDevice> device)
{
  this->StopTouch();
  Live& inner = *this->Inner;
  vtkRenderer* renderer = this->Led();
  if (renderer == nullptr)
  {
    vtkErrorMacro("There is no renderer to touch in: set the style on the interactor of a window "
                  "that has one.");
    return false;
  }
  inner.Device = std::move(device);
  palpate::TouchScene scene;
  scene.Structures = inner.Structures;
  scene.Tool = palpate::ToolShape::Sphere(this->ToolRadius);
  inner.Frame = palpate::WorkspaceFrame::Around(scene, inner.Device->Capabilities());
  inner.Frame.Scale = this->Scale > 0.0 ? this->Scale : inner.Frame.Scale;
  inner.Frame.Rotation = palpate::CameraAxes(renderer->GetActiveCamera());
  inner.Watch = {};
  inner.Newest = {};
  inner.Clutch = {};
  const palpate::Vector3 towardsViewer = inner.Frame.Rotation.col(2);
  const palpate::Vector3 first =
      inner.Frame.FirstHand(towardsViewer, inner.Device->Capabilities().Workspace);
  this->SetHandWorld(inner.Frame.ToWorld(first).data());
  this->SetHand(dynamic_cast<palpate::SimulatedDevice*>(inner.Device.get()) != nullptr);
  this->TakeHand();
  inner.Thread =
      std::make_unique<palpate::ServoThread>(*inner.Device, inner.Clock, palpate::ServoSettings());
  bool isStarted = this->Publish();
  if (isStarted)
  {
    const palpate::Status status = inner.Thread->Start({});
    isStarted = status.IsOk();
    if (!isStarted)
    {
      vtkErrorMacro(<< status.Message());
    }
  }
  if (!isStarted)
  {
    this->StopTouch();
    return false;
  }
  inner.Probe->SetToolSphere(this->ToolRadius);
  inner.Probe->VisibilityOn();
  inner.DrawnIn = renderer;
  inner.Drawn.AddTo(renderer);
  inner.Timer = this->Interactor->CreateRepeatingTimer(PollInterval);
  return true;
}

void vtkInteractorStyleHaptic::StopTouch()
{
  Live& inner = *this->Inner;
  this->HandOff();
  inner.Thread.reset(); // ends with 0 N
  if (inner.Device != nullptr)
  {
    inner.Device->Close();
    inner.Device.reset();
  }
  if (inner.Timer != 0 && this->Interactor != nullptr)
  {
    this->Interactor->DestroyTimer(inner.Timer);
  }
  inner.Timer = 0;
  if (inner.DrawnIn != nullptr)
  {
    inner.Drawn.RemoveFrom(inner.DrawnIn);
    inner.DrawnIn = nullptr;
  }
  inner.Probe->VisibilityOff();
}

bool vtkInteractorStyleHaptic::IsTouching()
{
  return this->Inner->Thread != nullptr;
}

void vtkInteractorStyleHaptic::SwitchForcesOff()
{
  if (this->IsTouching())
  {
    this->Inner->Thread->Loop().SwitchOff();
  }
}

void vtkInteractorStyleHaptic::SwitchForcesOn()
{
  if (this->IsTouching())
  {
    this->Inner->Thread->Loop().Rearm();
  }
}

vtkProbeRepresentation* vtkInteractorStyleHaptic::GetProbe()
{
  return this->Inner->Probe;
}

std::string vtkInteractorStyleHaptic::GetStatusText()
{
  const Live& inner = *this->Inner;
  if (!this->IsTouching())
  {
    return "Nothing is touched.";
  }
  const std::string problem = inner.Device->Problem();
  const std::string guidance = inner.Device->Guidance();
  const std::string& ofDevice = problem.empty() ? guidance : problem;
  return ofDevice.empty() ? palpate::Describe(inner.Newest.Safety.Fault) : ofDevice;
}

// The servo is told when the camera has come to rest: forces fade in for every new frame.
void vtkInteractorStyleHaptic::FollowCamera()
{
  Live& inner = *this->Inner;
  if (this->State != VTKIS_NONE || inner.DrawnIn == nullptr || inner.Clutch.IsHeld())
  {
    return;
  }
  palpate::WorkspaceFrame turned = inner.Frame;
  turned.Rotation = palpate::CameraAxes(inner.DrawnIn->GetActiveCamera());
  // Rounding of a camera that was not moved is no turn.
  constexpr double LeastTurn = 1e-6;
  if ((turned.Rotation - inner.Frame.Rotation).norm() > LeastTurn)
  {
    this->MoveFrame(turned);
  }
}

// The hand keeps its place in the device, and so has another in the world.
void vtkInteractorStyleHaptic::MoveFrame(const palpate::WorkspaceFrame& frame)
{
  Live& inner = *this->Inner;
  const palpate::Vector3 hand = inner.Frame.ToDevice(palpate::Vector3(this->GetHandWorld()));
  inner.Frame = frame;
  this->SetHandWorld(frame.ToWorld(hand).data());
  this->Publish();
}

void vtkInteractorStyleHaptic::HoldClutch(bool isHeld)
{
  Live& inner = *this->Inner;
  if (isHeld && !inner.Clutch.IsHeld())
  {
    inner.Clutch.Hold(inner.Newest.ProbeWorld);
    this->Publish();
  }
  else if (!isHeld && inner.Clutch.IsHeld())
  {
    this->MoveFrame(inner.Clutch.Release(inner.Frame, inner.Newest.Sample.Position));
  }
}

void vtkInteractorStyleHaptic::ShowNewest()
{
  Live& inner = *this->Inner;
  const palpate::TouchState& now = inner.Newest;
  const palpate::Vector3 probe =
      inner.Clutch.IsHeld() ? inner.Clutch.PlaceWorld() : palpate::Vector3(now.ProbeWorld);
  const bool isTouched = now.Structure >= 0;
  const palpate::Vector3 proxy = isTouched ? palpate::Vector3(now.ProxyWorld) : probe;
  inner.Probe->SetProbePosition(probe[0], probe[1], probe[2]);
  inner.Probe->SetProxyPosition(proxy[0], proxy[1], proxy[2]);
  inner.Probe->SetForce(now.ForceWorld.X, now.ForceWorld.Y, now.ForceWorld.Z);
  inner.Probe->SetInContact(isTouched);
  inner.Drawn.Update(this->ProbeVisibility ? inner.Probe.Get() : nullptr);
}

void vtkInteractorStyleHaptic::TellChanges()
{
  using Kind = palpate::TouchChange::Kind;
  // An observer may stop the touch, or poll.
  const std::vector<palpate::TouchChange> changes = std::move(this->Inner->Changes);
  this->Inner->Changes.clear();
  for (const palpate::TouchChange& change : changes)
  {
    int structure = change.Structure;
    int button = change.Button;
    const bool isPress = change.What == Kind::ButtonPressed;
    switch (change.What)
    {
    case Kind::ContactBegins:
      this->InvokeEvent(ContactBeginEvent, &structure);
      break;
    case Kind::ContactEnds:
      this->InvokeEvent(ContactEndEvent, &structure);
      break;
    case Kind::ButtonPressed:
    case Kind::ButtonReleased:
      if (button == this->ClutchButton && this->IsTouching())
      {
        this->HoldClutch(isPress);
      }
      this->InvokeEvent(isPress ? ButtonPressEvent : ButtonReleaseEvent, &button);
      break;
    case Kind::Fault:
      this->InvokeEvent(FaultEvent, const_cast<char*>(palpate::Describe(change.Why)));
      break;
    case Kind::ForcesOn:
      break;
    }
  }
}

void vtkInteractorStyleHaptic::Poll()
{
  Live& inner = *this->Inner;
  if (!this->IsTouching())
  {
    return;
  }
  palpate::Servo& servo = inner.Thread->Loop();
  servo.Reclaim();
  while (servo.PopRecorded(inner.Newest))
  {
    inner.Watch.Take(inner.Newest, inner.Changes);
  }
  this->TellChanges();
  if (this->IsTouching())
  {
    this->FollowCamera();
    this->ShowNewest();
  }
}

void vtkInteractorStyleHaptic::OnTimer()
{
  if (!this->IsTouching())
  {
    this->Superclass::OnTimer();
    return;
  }
  const vtkMTimeType before = this->Inner->Probe->GetMTime();
  this->Poll();
  if (this->Inner->Probe->GetMTime() != before)
  {
    this->Interactor->Render();
  }
}

// Leads a computed hand to where the mouse wants it, but not beyond what the device reaches.
void vtkInteractorStyleHaptic::TakeHand()
{
  Live& inner = *this->Inner;
  auto* simulated = dynamic_cast<palpate::SimulatedDevice*>(inner.Device.get());
  if (simulated != nullptr)
  {
    const palpate::Vector3 reached = inner.Frame.NearestInReach(
        palpate::Vector3(this->GetHandWorld()), inner.Device->Capabilities().Workspace);
    this->SetHandWorld(inner.Frame.ToWorld(reached).data());
    simulated->SetTarget(reached);
  }
}

void vtkInteractorStyleHaptic::OnKeyPress()
{
  const char* key = this->Interactor->GetKeySym();
  if (key != nullptr && std::strcmp(key, "Escape") == 0)
  {
    this->SwitchForcesOff();
    return;
  }
  this->Superclass::OnKeyPress();
}

void vtkInteractorStyleHaptic::OnChar()
{
  if (this->IsTouching() && this->Interactor->GetKeyCode() == 'f')
  {
    this->SwitchForcesOn();
    return;
  }
  this->Superclass::OnChar();
}

void vtkInteractorStyleHaptic::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  if (interactor != this->Interactor)
  {
    this->StopTouch();
  }
  this->Superclass::SetInteractor(interactor);
}

void vtkInteractorStyleHaptic::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Structures: " << this->GetNumberOfStructures() << '\n';
  os << indent << "DeviceName: " << (this->DeviceName != nullptr ? this->DeviceName : "(none)")
     << '\n';
  os << indent << "ToolRadius: " << this->ToolRadius << '\n';
  os << indent << "Scale: " << this->Scale << '\n';
  os << indent << "ClutchButton: " << this->ClutchButton << '\n';
  os << indent << "ProbeVisibility: " << this->ProbeVisibility << '\n';
  os << indent << "Touching: " << this->IsTouching() << '\n';
}
