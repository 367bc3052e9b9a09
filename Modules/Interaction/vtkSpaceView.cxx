#include "vtkSpaceView.h"

#include "AnatomicalView.h"
#include "AxesMarker.h"
#include "CameraAxes.h"
#include "ColorBar.h"
#include "LandmarksInSpace.h"
#include "ProbeInSpace.h"
#include "SliceInSpace.h"
#include "SurfaceInSpace.h"
#include "SurfaceMaterial.h"
#include "ViewText.h"
#include "WorkspaceLines.h"
#include "vtkCrosshair.h"
#include "vtkImageDisplay.h"
#include "vtkLandmarks.h"
#include "vtkProbeRepresentation.h"
#include "vtkSubVoxelPicker.h"
#include "vtkSurfaceDisplay.h"
#include "vtkWorkspaceRepresentation.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellPicker.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <vector>

using palpate::SliceOrientation;
using palpate::Vector3;

vtkStandardNewMacro(vtkSpaceView);

namespace
{
// VTK leaves room for a ball round everything, of which boxes and organs fill less.
constexpr double FitCloseness = 1.15;
} // namespace

struct vtkSpaceView::State
{
  vtkSmartPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;
  vtkSmartPointer<vtkImageDisplay> Display;
  vtkSmartPointer<vtkCrosshair> Crosshair;
  vtkSmartPointer<vtkLandmarks> Landmarks;
  vtkSmartPointer<vtkProbeRepresentation> Probe;
  vtkSmartPointer<vtkWorkspaceRepresentation> Workspace;
  vtkSmartPointer<vtkSurfaceDisplay> Picked;

  bool NeedsReset = true;
  std::vector<std::unique_ptr<palpate::SurfaceInSpace>> Surfaces;
  std::array<palpate::SliceInSpace, 3> Slices{{palpate::SliceInSpace(SliceOrientation::Axial),
                                               palpate::SliceInSpace(SliceOrientation::Coronal),
                                               palpate::SliceInSpace(SliceOrientation::Sagittal)}};
  std::array<bool, 3> AreSlicesShown{{true, true, true}};
  palpate::LandmarksInSpace Marks;
  palpate::ProbeInSpace Tool;
  palpate::WorkspaceLines Reach;
  palpate::AxesMarker Axes;
  palpate::ColorBar Bar;
  vtkNew<vtkLight> Lamp;

  void AddTo(vtkRenderer* renderer)
  {
    for (const auto& surface : this->Surfaces)
    {
      renderer->AddViewProp(surface->Actor());
    }
    for (const palpate::SliceInSpace& slice : this->Slices)
    {
      slice.AddTo(renderer);
    }
    this->Marks.SetRenderer(renderer);
    this->Tool.AddTo(renderer);
    this->Reach.AddTo(renderer);
    this->Axes.AddTo(renderer);
    this->Bar.AddTo(renderer);
    renderer->AddLight(this->Lamp);
  }
  void RemoveFrom(vtkRenderer* renderer)
  {
    for (const auto& surface : this->Surfaces)
    {
      renderer->RemoveViewProp(surface->Actor());
    }
    for (const palpate::SliceInSpace& slice : this->Slices)
    {
      slice.RemoveFrom(renderer);
    }
    this->Marks.SetRenderer(nullptr);
    this->Tool.RemoveFrom(renderer);
    this->Reach.RemoveFrom(renderer);
    this->Axes.RemoveFrom(renderer);
    this->Bar.RemoveFrom(renderer);
    renderer->RemoveLight(this->Lamp);
  }
  bool PickPolygons(double x, double y, double world[3])
  {
    vtkNew<vtkCellPicker> picker;
    picker->SetTolerance(0.0);
    picker->PickFromListOn();
    for (const auto& surface : this->Surfaces)
    {
      picker->AddPickList(surface->Actor());
    }
    for (const palpate::SliceInSpace& slice : this->Slices)
    {
      picker->AddPickList(slice.Actor());
    }
    if (picker->Pick(x, y, 0.0, this->Renderer) == 0)
    {
      return false;
    }
    picker->GetPickPosition(world);
    for (const auto& surface : this->Surfaces)
    {
      if (surface->Actor() == picker->GetActor())
      {
        this->Picked = surface->Display();
      }
    }
    return true;
  }
  // Turns the camera round what it looks at.
  void Look(const palpate::ViewFrame& frame)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const Vector3 eye =
        Vector3(camera->GetFocalPoint()) + camera->GetDistance() * frame.TowardsViewerWorld;
    camera->SetPosition(eye.data());
    camera->SetViewUp(frame.UpWorld.data());
  }
  // Along the line of sight.
  double Distance(const double world[3])
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    return (Vector3(world) - Vector3(camera->GetPosition()))
        .dot(Vector3(camera->GetDirectionOfProjection()));
  }
};

vtkSpaceView::vtkSpaceView() : Inner(std::make_unique<State>())
{
  this->Inner->Lamp->SetLightTypeToCameraLight();
  this->Inner->Lamp->SetPosition(palpate::SurfaceMaterial::Lamp[0],
                                 palpate::SurfaceMaterial::Lamp[1],
                                 palpate::SurfaceMaterial::Lamp[2]);
}

vtkSpaceView::~vtkSpaceView()
{
  this->SetRenderer(nullptr);
}

void vtkSpaceView::SetRenderer(vtkRenderer* renderer)
{
  State& state = *this->Inner;
  if (state.Renderer == renderer)
  {
    return;
  }
  if (state.Renderer != nullptr)
  {
    state.Renderer->RemoveObserver(state.Observer);
    state.RemoveFrom(state.Renderer);
  }
  state.Renderer = renderer;
  if (renderer != nullptr)
  {
    state.Observer = renderer->AddObserver(vtkCommand::StartEvent, this, &vtkSpaceView::Update);
    state.AddTo(renderer);
    state.NeedsReset = true;
  }
  this->Modified();
}

vtkRenderer* vtkSpaceView::GetRenderer()
{
  return this->Inner->Renderer;
}

void vtkSpaceView::SetImageDisplay(vtkImageDisplay* display)
{
  this->Inner->Display = display;
  this->Modified();
}

void vtkSpaceView::SetCrosshair(vtkCrosshair* crosshair)
{
  this->Inner->Crosshair = crosshair;
  this->Modified();
}

void vtkSpaceView::SetLandmarks(vtkLandmarks* landmarks)
{
  this->Inner->Landmarks = landmarks;
  this->Modified();
}

void vtkSpaceView::SetProbe(vtkProbeRepresentation* probe)
{
  this->Inner->Probe = probe;
  this->Modified();
}

void vtkSpaceView::SetWorkspace(vtkWorkspaceRepresentation* workspace)
{
  this->Inner->Workspace = workspace;
  this->Modified();
}

void vtkSpaceView::AddSurface(vtkSurfaceDisplay* surface)
{
  this->Inner->Surfaces.push_back(std::make_unique<palpate::SurfaceInSpace>(surface));
  if (this->Inner->Renderer != nullptr)
  {
    this->Inner->Renderer->AddViewProp(this->Inner->Surfaces.back()->Actor());
  }
  this->Modified();
}

void vtkSpaceView::RemoveSurface(vtkSurfaceDisplay* surface)
{
  auto& surfaces = this->Inner->Surfaces;
  const auto gone =
      std::find_if(surfaces.begin(), surfaces.end(),
                   [surface](const auto& shown) { return shown->Display() == surface; });
  if (gone != surfaces.end())
  {
    if (this->Inner->Renderer != nullptr)
    {
      this->Inner->Renderer->RemoveViewProp((*gone)->Actor());
    }
    surfaces.erase(gone);
    this->Modified();
  }
}

void vtkSpaceView::SetSliceVisibility(int orientation, bool visibility)
{
  const int index = vtkMath::ClampValue(orientation, 0, 2);
  this->Inner->AreSlicesShown[static_cast<std::size_t>(index)] = visibility;
  this->Modified();
}

bool vtkSpaceView::GetSliceVisibility(int orientation)
{
  const int index = vtkMath::ClampValue(orientation, 0, 2);
  return this->Inner->AreSlicesShown[static_cast<std::size_t>(index)];
}

void vtkSpaceView::ResetCamera()
{
  State& state = *this->Inner;
  double bounds[6];
  if (state.Renderer == nullptr)
  {
    return;
  }
  this->UpdateContents();
  // A workspace may be much larger than what there is to look at.
  state.Reach.Drawn().Actor()->UseBoundsOff();
  state.Renderer->ComputeVisiblePropBounds(bounds);
  state.Reach.Drawn().Actor()->UseBoundsOn();
  if (vtkMath::AreBoundsInitialized(bounds))
  {
    state.Renderer->ResetCamera(bounds);
    state.Renderer->GetActiveCamera()->Dolly(FitCloseness);
    state.NeedsReset = false;
  }
}

void vtkSpaceView::LookFrom(int side)
{
  if (this->Inner->Renderer == nullptr)
  {
    return;
  }
  const palpate::ViewFrame frame = palpate::FrameOf(palpate::AllViewSides[static_cast<std::size_t>(
      vtkMath::ClampValue(side, static_cast<int>(ANTERIOR), static_cast<int>(INFERIOR)))]);
  this->Inner->Look(frame);
  this->ResetCamera();
}

bool vtkSpaceView::Pick(double x, double y, double world[3])
{
  State& state = *this->Inner;
  state.Picked = nullptr;
  if (state.Renderer == nullptr)
  {
    return false;
  }
  double polygon[3];
  const bool hasPolygon = state.PickPolygons(x, y, polygon);
  vtkNew<vtkSubVoxelPicker> picker;
  const bool hasVoxels = picker->Pick(x, y, 0.0, state.Renderer) != 0;
  if (hasVoxels &&
      (!hasPolygon || state.Distance(picker->GetPickPosition()) < state.Distance(polygon)))
  {
    state.Picked = nullptr;
    picker->GetPickPosition(world);
    return true;
  }
  if (hasPolygon)
  {
    std::copy_n(polygon, 3, world);
  }
  return hasPolygon;
}

vtkSurfaceDisplay* vtkSpaceView::GetPickedSurface()
{
  return this->Inner->Picked;
}

void vtkSpaceView::UpdateContents()
{
  State& state = *this->Inner;
  for (const auto& surface : state.Surfaces)
  {
    surface->Update();
  }
  const Vector3 focus = state.Crosshair == nullptr ? Vector3(Vector3::Zero())
                                                   : Vector3(state.Crosshair->GetPositionWorld());
  for (std::size_t orientation = 0; orientation < 3; ++orientation)
  {
    state.Slices[orientation].SetVisible(state.AreSlicesShown[orientation]);
    state.Slices[orientation].Update(state.Display, this->AlongImage, focus);
  }
  state.Marks.Update(state.Landmarks);
  state.Tool.Update(state.Probe);
  state.Reach.Update(state.Workspace);
}

void vtkSpaceView::Update()
{
  State& state = *this->Inner;
  if (state.Renderer == nullptr)
  {
    return;
  }
  this->UpdateContents();
  if (state.NeedsReset)
  {
    state.Look(palpate::ObliqueFrame());
    this->ResetCamera();
  }
  state.Renderer->ResetCameraClippingRange();
  for (const auto& surface : state.Surfaces)
  {
    surface->UpdateContact(state.Probe, state.Renderer->GetActiveCamera());
  }
  this->UpdateAnnotation();
}

void vtkSpaceView::UpdateAnnotation()
{
  State& state = *this->Inner;
  const auto colored =
      std::find_if(state.Surfaces.begin(), state.Surfaces.end(),
                   [](const auto& surface)
                   { return surface->Colors() != nullptr && surface->Display()->GetVisibility(); });
  if (this->AnnotationVisibility && colored != state.Surfaces.end())
  {
    state.Bar.Update((*colored)->Colors(), (*colored)->Display()->GetColorArray());
  }
  else
  {
    state.Bar.Update(nullptr, {});
  }
  state.Axes.SetVisible(this->AnnotationVisibility);
  const palpate::Matrix3 axes = palpate::CameraAxes(state.Renderer->GetActiveCamera());
  state.Axes.Update({axes.col(0), axes.col(1), axes.col(2)}, state.Renderer->GetSize()[0],
                    palpate::PointPixels(state.Renderer));
}

void vtkSpaceView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Inner->Renderer.Get() << '\n';
  os << indent << "Surfaces: " << this->Inner->Surfaces.size() << '\n';
  os << indent << "AlongImage: " << this->AlongImage << '\n';
  os << indent << "AnnotationVisibility: " << this->AnnotationVisibility << '\n';
}
