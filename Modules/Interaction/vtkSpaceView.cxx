#include "vtkSpaceView.h"

#include "AnatomicalView.h"
#include "ArrayScales.h"
#include "AxesMarker.h"
#include "CameraAxes.h"
#include "ColorBar.h"
#include "ContactMark.h"
#include "GradedGround.h"
#include "LandmarksInSpace.h"
#include "PlumbLine.h"
#include "ProbeInSpace.h"
#include "SliceInSpace.h"
#include "SurfaceInSpace.h"
#include "SurfaceMaterial.h"
#include "ToolShadow.h"
#include "ViewText.h"
#include "vtkCrosshair.h"
#include "vtkImageDisplay.h"
#include "vtkLandmarks.h"
#include "vtkProbeRepresentation.h"
#include "vtkSubVoxelPicker.h"
#include "vtkSubVoxelVolumeMapper.h"
#include "vtkSurfaceDisplay.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellPicker.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <algorithm>
#include <array>
#include <vector>

using palpate::SliceOrientation;
using palpate::Vector3;

vtkStandardNewMacro(vtkSpaceView);

namespace
{
// VTK leaves space for a sphere around everything, which boxes and organs do not fill.
constexpr double FitCloseness = 1.15;

// Of the scene's size. A smaller bias darkens surfaces by their own facets.
constexpr double OcclusionReach = 0.1;
constexpr double OcclusionBias = 0.001;
constexpr unsigned int OcclusionSamples = 32;

constexpr int MostPeels = 4;

// Rotates the camera around its focal point.
void Look(vtkCamera* camera, const palpate::ViewFrame& frame)
{
  const Vector3 eye =
      Vector3(camera->GetFocalPoint()) + camera->GetDistance() * frame.TowardsViewerWorld;
  camera->SetPosition(eye.data());
  camera->SetViewUp(frame.UpWorld.data());
}

// Along the line of sight.
double DistanceFrom(vtkCamera* camera, const double world[3])
{
  return (Vector3(world) - Vector3(camera->GetPosition()))
      .dot(Vector3(camera->GetDirectionOfProjection()));
}

// Around the point that the tool touches.
palpate::ContactMark MarkOf(vtkProbeRepresentation* probe)
{
  palpate::ContactMark mark;
  if (probe == nullptr || !probe->GetVisibility() || !probe->GetInContact())
  {
    return mark;
  }
  mark.PlaceWorld = probe->ContactWorld();
  mark.Radius = probe->GetContactRadius();
  mark.Color = Vector3(probe->GetContactColor());
  return mark;
}

palpate::ToolShadow ShadowOf(vtkProbeRepresentation* probe)
{
  const bool isShown = probe != nullptr && probe->GetVisibility();
  return isShown ? palpate::ToolShadow{probe->ProxyWorld(), probe->GetToolRadius()}
                 : palpate::ToolShadow{};
}

// Texts on it are dark.
bool IsGroundLight(vtkRenderer* renderer)
{
  const double* ground = renderer->GetBackground();
  return 0.3 * ground[0] + 0.6 * ground[1] + 0.1 * ground[2] > 0.5;
}

void MarkVolumes(vtkRenderer* renderer, const palpate::ContactMark& contact)
{
  const double grey = IsGroundLight(renderer) ? 0.1 : 1.0;
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator place;
  volumes->InitTraversal(place);
  while (vtkVolume* volume = volumes->GetNextVolume(place))
  {
    if (auto* mapper = vtkSubVoxelVolumeMapper::SafeDownCast(volume->GetMapper()))
    {
      mapper->SetContact(contact);
      mapper->SetOutlineColor(grey, grey, grey);
    }
  }
}
} // namespace

struct vtkSpaceView::State
{
  bool NeedsReset = true;
  std::vector<std::unique_ptr<palpate::SurfaceInSpace>> Surfaces;
  std::array<palpate::SliceInSpace, 3> Slices{{palpate::SliceInSpace(SliceOrientation::Axial),
                                               palpate::SliceInSpace(SliceOrientation::Coronal),
                                               palpate::SliceInSpace(SliceOrientation::Sagittal)}};
  std::array<bool, 3> AreSlicesShown{{true, true, true}};
  palpate::LandmarksInSpace Marks;
  palpate::ProbeInSpace Tool;
  palpate::PlumbLine Depth;
  palpate::AxesMarker Axes;
  palpate::ArrayScales Scales;
  palpate::ColorBar Bar;
  vtkNew<palpate::GradedGround> Ground;
  std::array<vtkNew<vtkLight>, palpate::SurfaceMaterial::Lamps.size()> Lamps;

  // The actor of a surface or a slice, or null.
  vtkActor* PickPolygons(vtkRenderer* renderer, double x, double y, double world[3])
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
    if (picker->Pick(x, y, 0.0, renderer) == 0)
    {
      return nullptr;
    }
    picker->GetPickPosition(world);
    return picker->GetActor();
  }

  // A single one needs no order.
  std::ptrdiff_t TranslucentCount() const
  {
    return std::count_if(this->Surfaces.begin(), this->Surfaces.end(),
                         [](const auto& surface)
                         {
                           const double opacity = surface->Display()->GetOpacity();
                           return surface->Actor()->GetVisibility() != 0 && opacity > 0.0 &&
                                  opacity < 1.0;
                         });
  }

  // The surface that an actor draws, or null if it draws a slice.
  vtkSurfaceDisplay* DisplayOf(vtkActor* actor) const
  {
    const auto found =
        std::find_if(this->Surfaces.begin(), this->Surfaces.end(),
                     [actor](const auto& surface) { return surface->Actor() == actor; });
    return found != this->Surfaces.end() ? (*found)->Display() : nullptr;
  }
};

vtkSpaceView::vtkSpaceView() : Inner(std::make_unique<State>())
{
  using palpate::SurfaceMaterial;
  for (std::size_t lamp = 0; lamp < SurfaceMaterial::Lamps.size(); ++lamp)
  {
    SurfaceMaterial::Set(this->Inner->Lamps[lamp].Get(), SurfaceMaterial::Lamps[lamp]);
  }
}

vtkSpaceView::~vtkSpaceView()
{
  this->SetRenderer(nullptr);
}

void vtkSpaceView::AddTo(vtkRenderer* renderer)
{
  State& state = *this->Inner;
  for (const auto& surface : state.Surfaces)
  {
    surface->AddTo(renderer);
  }
  for (const palpate::SliceInSpace& slice : state.Slices)
  {
    slice.AddTo(renderer);
  }
  state.Marks.SetRenderer(renderer);
  state.Tool.AddTo(renderer);
  state.Depth.SetRenderer(renderer);
  state.Axes.AddTo(renderer);
  state.Bar.AddTo(renderer);
  renderer->AddViewProp(state.Ground);
  for (const auto& lamp : state.Lamps)
  {
    renderer->AddLight(lamp);
  }
  renderer->SetOcclusionRatio(0.0);
  renderer->SetMaximumNumberOfPeels(MostPeels);
  // Now, since the camera may be reset before anything is drawn.
  Look(renderer->GetActiveCamera(), palpate::ObliqueFrame());
  state.NeedsReset = true;
}

void vtkSpaceView::RemoveFrom(vtkRenderer* renderer)
{
  State& state = *this->Inner;
  for (const auto& surface : state.Surfaces)
  {
    surface->RemoveFrom(renderer);
  }
  for (const palpate::SliceInSpace& slice : state.Slices)
  {
    slice.RemoveFrom(renderer);
  }
  state.Marks.SetRenderer(nullptr);
  state.Tool.RemoveFrom(renderer);
  state.Depth.SetRenderer(nullptr);
  state.Axes.RemoveFrom(renderer);
  state.Bar.RemoveFrom(renderer);
  renderer->RemoveViewProp(state.Ground);
  for (const auto& lamp : state.Lamps)
  {
    renderer->RemoveLight(lamp);
  }
}

void vtkSpaceView::AddSurface(vtkSurfaceDisplay* surface)
{
  this->Inner->Surfaces.push_back(std::make_unique<palpate::SurfaceInSpace>(surface));
  if (vtkRenderer* renderer = this->GetRenderer())
  {
    this->Inner->Surfaces.back()->AddTo(renderer);
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
    if (vtkRenderer* renderer = this->GetRenderer())
    {
      (*gone)->RemoveFrom(renderer);
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

void vtkSpaceView::ResetCamera()
{
  vtkRenderer* renderer = this->GetRenderer();
  double bounds[6];
  if (renderer == nullptr)
  {
    return;
  }
  this->UpdateContents();
  const auto& surfaces = this->Inner->Surfaces;
  for (const auto& surface : surfaces)
  {
    surface->Actor()->SetUseBounds(!surface->Display()->GetWireframe());
  }
  renderer->ComputeVisiblePropBounds(bounds);
  // The clipping range includes wireframes.
  for (const auto& surface : surfaces)
  {
    surface->Actor()->UseBoundsOn();
  }
  if (vtkMath::AreBoundsInitialized(bounds))
  {
    renderer->ResetCamera(bounds);
    renderer->GetActiveCamera()->Dolly(FitCloseness);
    this->Inner->NeedsReset = false;
  }
}

bool vtkSpaceView::IsCameraInside()
{
  vtkRenderer* renderer = this->GetRenderer();
  if (renderer == nullptr)
  {
    return false;
  }
  this->UpdateContents();
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  return vtkMath::AreBoundsInitialized(bounds) &&
         vtkBoundingBox(bounds).ContainsPoint(renderer->GetActiveCamera()->GetPosition());
}

void vtkSpaceView::LookFrom(int side)
{
  vtkRenderer* renderer = this->GetRenderer();
  if (renderer == nullptr)
  {
    return;
  }
  const palpate::ViewFrame frame = palpate::FrameOf(palpate::AllViewSides[static_cast<std::size_t>(
      vtkMath::ClampValue(side, static_cast<int>(ANTERIOR), static_cast<int>(INFERIOR)))]);
  Look(renderer->GetActiveCamera(), frame);
  this->ResetCamera();
}

bool vtkSpaceView::Pick(double x, double y, double world[3])
{
  return this->PickObject(x, y, world) != nullptr;
}

vtkObject* vtkSpaceView::PickObject(double x, double y, double world[3])
{
  vtkRenderer* renderer = this->GetRenderer();
  if (renderer == nullptr)
  {
    return nullptr;
  }
  double polygon[3];
  vtkActor* actor = this->Inner->PickPolygons(renderer, x, y, polygon);
  vtkNew<vtkSubVoxelPicker> picker;
  const bool hasVoxels = picker->Pick(x, y, 0.0, renderer) != 0;
  vtkCamera* camera = renderer->GetActiveCamera();
  if (hasVoxels && (actor == nullptr || DistanceFrom(camera, picker->GetPickPosition()) <
                                            DistanceFrom(camera, polygon)))
  {
    picker->GetPickPosition(world);
    return picker->GetViewProp();
  }
  if (actor == nullptr)
  {
    return nullptr;
  }
  std::copy_n(polygon, 3, world);
  vtkSurfaceDisplay* surface = this->Inner->DisplayOf(actor);
  return surface != nullptr ? static_cast<vtkObject*>(surface) : this->GetImageDisplay();
}

void vtkSpaceView::UpdateContents()
{
  State& state = *this->Inner;
  for (const auto& surface : state.Surfaces)
  {
    surface->Update();
  }
  state.Scales.Update(state.Surfaces);
  vtkCrosshair* crosshair = this->GetCrosshair();
  const Vector3 focus =
      crosshair == nullptr ? Vector3(Vector3::Zero()) : Vector3(crosshair->GetPositionWorld());
  for (std::size_t orientation = 0; orientation < 3; ++orientation)
  {
    vtkImageDisplay* shown = state.AreSlicesShown[orientation] ? this->GetImageDisplay() : nullptr;
    state.Slices[orientation].Update(shown, this->GetAlongImage(), focus);
  }
  state.Marks.Update(this->GetLandmarks());
  state.Tool.Update(this->GetProbe());
  state.Depth.Update(this->GetProbe(), this->UnitOfLength());
}

void vtkSpaceView::UpdateFor(vtkRenderer* renderer)
{
  this->UpdateContents();
  if (this->Inner->NeedsReset)
  {
    this->ResetCamera();
  }
  renderer->ResetCameraClippingRange();
  const palpate::ContactMark contact = MarkOf(this->GetProbe());
  const palpate::ToolShadow shadow =
      this->ToolShadow ? ShadowOf(this->GetProbe()) : palpate::ToolShadow{};
  for (const auto& surface : this->Inner->Surfaces)
  {
    surface->UpdateContact(contact, renderer->GetActiveCamera());
    surface->UpdateShadow(shadow, renderer->GetActiveCamera());
    surface->UpdateOutline(IsGroundLight(renderer), palpate::PointPixels(renderer));
  }
  MarkVolumes(renderer, contact);
  this->UpdateAnnotation(renderer);
  this->UpdateQuality(renderer);
}

void vtkSpaceView::UpdateQuality(vtkRenderer* renderer)
{
  renderer->SetUseFXAA(this->Antialiasing && !this->Moving);
  const bool isOccluded =
      this->AmbientOcclusion && !this->Moving && renderer->GetVolumes()->GetNumberOfItems() == 0;
  renderer->SetUseSSAO(isOccluded);
  this->Inner->Ground->SetVisibility(isOccluded && renderer->GetGradientBackground());
  renderer->SetUseDepthPeeling(this->Inner->TranslucentCount() > 1);
  if (!isOccluded)
  {
    return;
  }
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  if (vtkMath::AreBoundsInitialized(bounds))
  {
    const double size = vtkBoundingBox(bounds).GetDiagonalLength();
    renderer->SetSSAORadius(OcclusionReach * size);
    renderer->SetSSAOBias(OcclusionBias * size);
    renderer->SetSSAOKernelSize(OcclusionSamples);
    renderer->SSAOBlurOn();
  }
}

void vtkSpaceView::UpdateAnnotation(vtkRenderer* renderer)
{
  State& state = *this->Inner;
  const bool isShown = this->GetAnnotationVisibility();
  const double grey = IsGroundLight(renderer) ? 0.1 : 1.0;
  state.Bar.Update(isShown ? state.Scales.FirstColors() : nullptr, state.Scales.FirstArray());
  state.Bar.SetGrey(grey);
  state.Axes.SetGrey(grey);
  state.Axes.SetVisible(isShown);
  const palpate::Matrix3 axes = palpate::CameraAxes(renderer->GetActiveCamera());
  state.Axes.Update({axes.col(0), axes.col(1), axes.col(2)}, renderer->GetSize()[0],
                    palpate::PointPixels(renderer));
}

void vtkSpaceView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surfaces: " << this->Inner->Surfaces.size() << '\n';
  os << indent << "Antialiasing: " << this->Antialiasing << '\n';
  os << indent << "AmbientOcclusion: " << this->AmbientOcclusion << '\n';
  os << indent << "Moving: " << this->Moving << '\n';
  os << indent << "ToolShadow: " << this->ToolShadow << '\n';
}
