#include "vtkInteractorStyleHaptic.h"

#include "CameraAxes.h"
#include "FacetContactModel.h"
#include "InputError.h"
#include "OpenBuiltInDevice.h"
#include "ProbeInSpace.h"
#include "SteadyClock.h"
#include "TouchSession.h"
#include "TriangleMesh.h"
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
#include <optional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkInteractorStyleHaptic);

namespace
{
constexpr unsigned long PollInterval = 16; // ms
constexpr double StrongestPush = 4.0;      // N, of the mouse as a hand
} // namespace

struct vtkInteractorStyleHaptic::Live
{
  std::vector<palpate::TouchStructure> Structures;
  palpate::SteadyClock Clock;
  palpate::TouchSessionReading Reading;
  int Timer = 0;
  vtkNew<vtkProbeRepresentation> Probe;
  palpate::ProbeInSpace Drawn;
  vtkWeakPointer<vtkRenderer> DrawnIn;
  int AimedAt = -1;                     // the structure that MostPush is for
  palpate::TouchSession Session{Clock}; // ends first
};

vtkInteractorStyleHaptic::vtkInteractorStyleHaptic() : Inner(std::make_unique<Live>())
{
  this->SetDeviceName("simulated");
  this->Inner->Probe->VisibilityOff();
  this->NeedsTimer = false;
  this->AddObserver(HandMovedEvent, this, &vtkInteractorStyleHaptic::TakeHand);
  this->AddObserver(AimedEvent, this, &vtkInteractorStyleHaptic::FindRest);
  this->AddObserver(PressedEvent, this, &vtkInteractorStyleHaptic::PressHand);
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
  if (this->IsTouching() && !this->Publish(this->Inner->Session.Frame()))
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
    this->Publish(this->Inner->Session.Frame());
  }
}

int vtkInteractorStyleHaptic::GetNumberOfStructures()
{
  return static_cast<int>(this->Inner->Structures.size());
}

palpate::TouchScene vtkInteractorStyleHaptic::MakeScene() const
{
  palpate::TouchScene scene;
  scene.Tool = palpate::ToolShape::Sphere(this->ToolRadius);
  scene.Structures = this->Inner->Structures;
  return scene;
}

bool vtkInteractorStyleHaptic::Publish(const palpate::WorkspaceFrame& frame)
{
  const palpate::Status status =
      this->Inner->Session.Publish(this->MakeScene(), frame, palpate::SceneEntry::FadeIn);
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
    vtkErrorMacro(
        "No renderer to touch in: set the style on the interactor of a window that has one.");
    return false;
  }
  palpate::TouchSession& session = inner.Session;
  session.SetClutchButton(this->ClutchButton);
  session.Open(std::move(device), palpate::ServoSettings());
  const palpate::TouchScene scene = this->MakeScene();
  const palpate::DeviceCapabilities& capabilities = session.Device().Capabilities();
  palpate::WorkspaceFrame frame = palpate::WorkspaceFrame::Around(scene, capabilities);
  frame.Scale = this->Scale > 0.0 ? this->Scale : frame.Scale;
  frame.Rotation = palpate::CameraAxes(renderer->GetActiveCamera());
  const palpate::Vector3 first = frame.FirstHand(frame.Rotation.col(2), capabilities.Workspace);
  this->SetHand(session.LeadHand(first));
  this->SetHandWorld(frame.ToWorld(first).data());
  const palpate::Status status = session.Start(scene, frame);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
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
  inner.Session.Stop();
  inner.Reading = {};
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
  return this->Inner->Session.IsRunning();
}

void vtkInteractorStyleHaptic::SwitchForcesOff()
{
  if (this->IsTouching())
  {
    this->Inner->Session.Loop().SwitchOff();
  }
}

void vtkInteractorStyleHaptic::SwitchForcesOn()
{
  if (this->IsTouching())
  {
    this->Inner->Session.Loop().Rearm();
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
    return "Touch is off.";
  }
  const std::string problem = inner.Session.Device().Problem();
  const std::string guidance = inner.Session.Device().Guidance();
  const std::string& ofDevice = problem.empty() ? guidance : problem;
  const palpate::SafetyReport& safety = inner.Reading.Newest.Safety;
  return ofDevice.empty() ? palpate::Describe(safety.Fault, safety.WillResume) : ofDevice;
}

// The servo gets a new frame only when the camera has come to rest, since forces fade in for each.
void vtkInteractorStyleHaptic::FollowCamera()
{
  Live& inner = *this->Inner;
  if (this->State != VTKIS_NONE || inner.DrawnIn == nullptr || inner.Reading.IsClutched)
  {
    return;
  }
  palpate::WorkspaceFrame turned = inner.Session.Frame();
  turned.Rotation = palpate::CameraAxes(inner.DrawnIn->GetActiveCamera());
  // Rounding of an unmoved camera is not a rotation.
  constexpr double LeastTurn = 1e-6;
  if ((turned.Rotation - inner.Session.Frame().Rotation).norm() > LeastTurn)
  {
    this->Publish(turned);
  }
}

void vtkInteractorStyleHaptic::ShowNewest()
{
  Live& inner = *this->Inner;
  const palpate::TouchState& now = inner.Reading.Newest;
  const palpate::Vector3 probe(now.ProbeWorld);
  const bool isTouched = now.Structure >= 0;
  const palpate::Vector3 proxy = isTouched ? palpate::Vector3(now.ProxyWorld) : probe;
  inner.Probe->SetProbePose(probe, now.ProbeOrientation);
  inner.Probe->SetProxyPose(proxy, now.ProxyOrientation);
  inner.Probe->SetForce(now.ForceWorld.X, now.ForceWorld.Y, now.ForceWorld.Z);
  inner.Probe->SetInContact(isTouched);
  inner.Drawn.Update(inner.Probe);
}

void vtkInteractorStyleHaptic::TellChanges()
{
  using Kind = palpate::TouchChange::Kind;
  // An observer may stop the touch, or poll.
  const std::vector<palpate::TouchChange> changes = std::move(this->Inner->Reading.Changes);
  this->Inner->Reading.Changes.clear();
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
      this->InvokeEvent(isPress ? ButtonPressEvent : ButtonReleaseEvent, &button);
      break;
    case Kind::Fault:
      this->InvokeEvent(FaultEvent,
                        const_cast<char*>(palpate::Describe(change.Why, change.WillResume)));
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
  const palpate::WorkspaceFrame before = inner.Session.Frame();
  inner.Reading = inner.Session.Poll();
  if (before != inner.Session.Frame())
  {
    this->SetHandWorld(inner.Session.HandWorld().data());
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
  this->Superclass::OnTimer();
  if (!this->IsTouching())
  {
    return;
  }
  const vtkMTimeType before = this->Inner->Probe->GetMTime();
  this->Poll();
  if (this->Inner->Probe->GetMTime() != before)
  {
    this->Interactor->Render();
  }
}

// The hand hovers without contact until it is pressed, so that it passes over everything.
void vtkInteractorStyleHaptic::FindRest()
{
  Live& inner = *this->Inner;
  if (!this->IsTouching())
  {
    return;
  }
  const std::optional<palpate::TouchRay::Rest> rest = inner.Session.RestBetween(
      palpate::Vector3(this->GetSightFrom()), palpate::Vector3(this->GetSightTo()));
  if (!rest)
  {
    return;
  }
  if (rest->Structure != inner.AimedAt)
  {
    inner.AimedAt = rest->Structure;
    this->SetMostPush(inner.Session.PushFor(StrongestPush, rest->Structure));
  }
  this->SetRest(rest->ToolWorld.data(), rest->NormalWorld.data());
  if (!this->IsPressed())
  {
    inner.Session.LiftHand();
  }
}

void vtkInteractorStyleHaptic::PressHand()
{
  this->Inner->Session.PressHand();
}

// Moves a simulated hand to the mouse's target, but not beyond the device's workspace.
void vtkInteractorStyleHaptic::TakeHand()
{
  palpate::TouchSession& session = this->Inner->Session;
  if (!this->IsTouching())
  {
    return;
  }
  const palpate::Vector3 reached = session.Frame().NearestInReach(
      palpate::Vector3(this->GetHandWorld()), session.Device().Capabilities().Workspace);
  if (session.LeadHand(reached))
  {
    this->SetHandWorld(session.HandWorld().data());
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
  os << indent << "Touching: " << this->IsTouching() << '\n';
}
