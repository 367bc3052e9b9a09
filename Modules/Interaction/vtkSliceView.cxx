#include "vtkSliceView.h"

#include "CrosshairInSlice.h"
#include "ImageAxes.h"
#include "LandmarksInSlice.h"
#include "ProbeInSlice.h"
#include "SliceAnnotation.h"
#include "SliceContours.h"
#include "SliceGeometry.h"
#include "SlicePainter.h"
#include "SlicePatch.h"
#include "ViewText.h"
#include "WorkspaceLines.h"
#include "vtkCrosshair.h"
#include "vtkImageDisplay.h"
#include "vtkLandmarks.h"
#include "vtkProbeRepresentation.h"
#include "vtkSurfaceDisplay.h"
#include "vtkWorkspaceRepresentation.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

using palpate::SliceGeometry;
using palpate::SliceOrientation;
using palpate::SlicePosition;
using palpate::Vector3;

vtkStandardNewMacro(vtkSliceView);

namespace
{
constexpr double FitMargin = 1.04;     // view over volume
constexpr double EyeDistance = 1000.0; // mm; in parallel projection any will do
constexpr double SmallestHeight = 0.5; // of a view, mm
constexpr double LargestHeight = 1e5;
constexpr double EmptyHeight = 200.0; // without a volume
} // namespace

struct vtkSliceView::State
{
  vtkSmartPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;
  vtkSmartPointer<vtkImageDisplay> Display;
  vtkSmartPointer<vtkCrosshair> Crosshair;
  vtkSmartPointer<vtkLandmarks> Landmarks;
  vtkSmartPointer<vtkProbeRepresentation> Probe;
  vtkSmartPointer<vtkWorkspaceRepresentation> Workspace;

  bool NeedsFit = true;
  Vector3 Center = Vector3::Zero(); // of the view, world; its height over the plane does not count
  double Height = EmptyHeight;      // of the view, mm

  palpate::SlicePatch Patch;
  palpate::PixelGrid PaintedGrid;
  vtkMTimeType PaintedTime = 0;
  int PaintCount = 0;
  palpate::SliceContours Contours;
  palpate::LandmarksInSlice Marks;
  palpate::ProbeInSlice Tool;
  palpate::WorkspaceLines Reach;
  palpate::CrosshairInSlice Pointer;
  palpate::SliceAnnotation Annotation;

  vtkImageData* Image() { return this->Display == nullptr ? nullptr : this->Display->GetImage(); }
  void AddTo(vtkRenderer* renderer)
  {
    renderer->AddViewProp(this->Patch.Actor());
    this->Contours.SetRenderer(renderer);
    this->Marks.SetRenderer(renderer);
    this->Tool.AddTo(renderer);
    this->Reach.AddTo(renderer);
    this->Pointer.AddTo(renderer);
    this->Annotation.AddTo(renderer);
  }
  void RemoveFrom(vtkRenderer* renderer)
  {
    renderer->RemoveViewProp(this->Patch.Actor());
    this->Contours.SetRenderer(nullptr);
    this->Marks.SetRenderer(nullptr);
    this->Tool.RemoveFrom(renderer);
    this->Reach.RemoveFrom(renderer);
    this->Pointer.RemoveFrom(renderer);
    this->Annotation.RemoveFrom(renderer);
  }
  SliceGeometry Geometry(const vtkSliceView* view)
  {
    return {static_cast<SliceOrientation>(view->Orientation), view->AlongImage, this->Image()};
  }
  Vector3 Focus() const
  {
    return this->Crosshair == nullptr ? this->Center : Vector3(this->Crosshair->GetPositionWorld());
  }
};

vtkSliceView::vtkSliceView() : Inner(std::make_unique<State>()) {}

vtkSliceView::~vtkSliceView()
{
  this->SetRenderer(nullptr);
}

void vtkSliceView::SetRenderer(vtkRenderer* renderer)
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
    state.Observer = renderer->AddObserver(vtkCommand::StartEvent, this, &vtkSliceView::Update);
    state.AddTo(renderer);
  }
  this->Modified();
}

vtkRenderer* vtkSliceView::GetRenderer()
{
  return this->Inner->Renderer;
}

void vtkSliceView::SetImageDisplay(vtkImageDisplay* display)
{
  if (this->Inner->Display != display)
  {
    this->Inner->Display = display;
    this->Inner->NeedsFit = true;
    this->Modified();
  }
}

vtkImageDisplay* vtkSliceView::GetImageDisplay()
{
  return this->Inner->Display;
}

void vtkSliceView::SetCrosshair(vtkCrosshair* crosshair)
{
  this->Inner->Crosshair = crosshair;
  this->Modified();
}

vtkCrosshair* vtkSliceView::GetCrosshair()
{
  return this->Inner->Crosshair;
}

void vtkSliceView::SetLandmarks(vtkLandmarks* landmarks)
{
  this->Inner->Landmarks = landmarks;
  this->Modified();
}

void vtkSliceView::SetProbe(vtkProbeRepresentation* probe)
{
  this->Inner->Probe = probe;
  this->Modified();
}

void vtkSliceView::SetWorkspace(vtkWorkspaceRepresentation* workspace)
{
  this->Inner->Workspace = workspace;
  this->Modified();
}

void vtkSliceView::AddSurface(vtkSurfaceDisplay* surface)
{
  this->Inner->Contours.Add(surface);
  this->Modified();
}

void vtkSliceView::RemoveSurface(vtkSurfaceDisplay* surface)
{
  this->Inner->Contours.Remove(surface);
  this->Modified();
}

void vtkSliceView::FitToImage()
{
  this->Inner->NeedsFit = true;
  this->Modified();
}

void vtkSliceView::Fit()
{
  State& state = *this->Inner;
  vtkImageData* image = state.Image();
  const int* size = state.Renderer->GetSize();
  if (image == nullptr || size[0] < 1 || size[1] < 1)
  {
    return;
  }
  const palpate::ViewFrame frame = state.Geometry(this).Frame;
  Eigen::AlignedBox2d box;
  for (const Vector3& corner : palpate::ImageAxes(image).CornersWorld())
  {
    box.extend(Eigen::Vector2d(corner.dot(frame.RightWorld), corner.dot(frame.UpWorld)));
  }
  const double aspect = static_cast<double>(size[0]) / size[1];
  state.Center = box.center().x() * frame.RightWorld + box.center().y() * frame.UpWorld;
  state.Height = FitMargin * std::max(box.sizes().y(), box.sizes().x() / aspect);
  state.NeedsFit = false;
}

SlicePosition vtkSliceView::GetPosition()
{
  State& state = *this->Inner;
  SlicePosition position;
  position.Frame = state.Geometry(this).Frame;
  const Vector3& normal = position.Frame.TowardsViewerWorld;
  position.CenterWorld = state.Center + normal.dot(state.Focus() - state.Center) * normal;
  if (state.Renderer != nullptr)
  {
    const int* size = state.Renderer->GetSize();
    position.Width = size[0];
    position.Height = size[1];
    position.PointPixels = palpate::PointPixels(state.Renderer);
  }
  position.PixelMillimeters = state.Height / std::max(1, position.Height);
  return position;
}

int vtkSliceView::GetPaintCount() const
{
  return this->Inner->PaintCount;
}

int vtkSliceView::GetCutCount() const
{
  return this->Inner->Contours.CutCount();
}

double vtkSliceView::GetPixelMillimeters()
{
  return this->GetPosition().PixelMillimeters;
}

void vtkSliceView::Scroll(int slices)
{
  vtkCrosshair* crosshair = this->Inner->Crosshair;
  if (crosshair != nullptr)
  {
    const Vector3 moved =
        this->Inner->Geometry(this).Moved(Vector3(crosshair->GetPositionWorld()), slices);
    crosshair->SetPositionWorld(moved.data());
  }
}

int vtkSliceView::GetSliceNumber()
{
  const SliceGeometry geometry = this->Inner->Geometry(this);
  return geometry.HasNumbers() ? geometry.NumberOf(this->Inner->Focus()) + 1 : 0;
}

int vtkSliceView::GetNumberOfSlices()
{
  return this->Inner->Geometry(this).Count;
}

void vtkSliceView::Zoom(double factor, double x, double y)
{
  if (!(factor > 0.0) || !std::isfinite(factor))
  {
    return;
  }
  Vector3 before;
  this->DisplayToWorld(x, y, before.data());
  this->Inner->Height = std::clamp(this->Inner->Height / factor, SmallestHeight, LargestHeight);
  Vector3 after;
  this->DisplayToWorld(x, y, after.data());
  this->Inner->Center += before - after;
  this->Modified();
}

void vtkSliceView::Pan(double right, double up)
{
  const SlicePosition position = this->GetPosition();
  this->Inner->Center -=
      position.PixelMillimeters * (right * position.Frame.RightWorld + up * position.Frame.UpWorld);
  this->Modified();
}

void vtkSliceView::CenterOnCrosshair()
{
  this->Inner->Center = this->Inner->Focus();
  this->Modified();
}

void vtkSliceView::DisplayToWorld(double x, double y, double world[3])
{
  const SlicePosition position = this->GetPosition();
  int origin[2] = {0, 0};
  if (this->Inner->Renderer != nullptr)
  {
    std::copy_n(this->Inner->Renderer->GetOrigin(), 2, origin);
  }
  const Vector3 point = position.ToWorld(x + 0.5 - origin[0], y + 0.5 - origin[1]);
  std::copy_n(point.data(), 3, world);
}

void vtkSliceView::MoveCrosshairTo(double x, double y)
{
  if (this->Inner->Crosshair != nullptr)
  {
    double world[3];
    this->DisplayToWorld(x, y, world);
    this->Inner->Crosshair->SetPositionWorld(world);
  }
}

void vtkSliceView::Update()
{
  State& state = *this->Inner;
  if (state.Renderer == nullptr)
  {
    return;
  }
  if (state.NeedsFit)
  {
    this->Fit();
  }
  const SlicePosition position = this->GetPosition();
  if (position.Width < 1 || position.Height < 1)
  {
    return;
  }
  this->PlaceCamera(position);
  this->UpdatePicture(position);
  state.Contours.Update(position);
  state.Marks.Update(state.Landmarks, position);
  state.Tool.Update(state.Probe, position);
  state.Reach.Update(state.Workspace, position);
  const auto orientation = static_cast<SliceOrientation>(this->Orientation);
  state.Pointer.Update(state.Crosshair, orientation, position);
  state.Annotation.SetVisible(this->AnnotationVisibility);
  if (this->AnnotationVisibility)
  {
    state.Annotation.Update(orientation, state.Geometry(this), position, state.Focus());
  }
}

void vtkSliceView::PlaceCamera(const SlicePosition& position)
{
  vtkCamera* camera = this->Inner->Renderer->GetActiveCamera();
  const Vector3 eye = position.CenterWorld + EyeDistance * position.Frame.TowardsViewerWorld;
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(position.CenterWorld.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(position.Frame.UpWorld.data());
  camera->SetParallelScale(0.5 * this->Inner->Height);
  camera->SetClippingRange(0.5 * EyeDistance, 1.5 * EyeDistance);
}

void vtkSliceView::UpdatePicture(const SlicePosition& position)
{
  State& state = *this->Inner;
  state.Patch.Actor()->SetVisibility(state.Display != nullptr ? 1 : 0);
  if (state.Display == nullptr)
  {
    return;
  }
  const palpate::PixelGrid grid = position.Pixels();
  const vtkMTimeType time = state.Display->GetMTime();
  if (grid == state.PaintedGrid && time == state.PaintedTime)
  {
    return;
  }
  palpate::PaintSlice(state.Display->GetContent(), grid, state.Patch.Picture());
  state.Patch.Place(grid, palpate::SlicePatch::CornersOf(grid));
  state.PaintedGrid = grid;
  state.PaintedTime = time;
  ++state.PaintCount;
}

void vtkSliceView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Inner->Renderer.Get() << '\n';
  os << indent
     << "Orientation: " << palpate::NameOf(static_cast<SliceOrientation>(this->Orientation))
     << '\n';
  os << indent << "AlongImage: " << this->AlongImage << '\n';
  os << indent << "AnnotationVisibility: " << this->AnnotationVisibility << '\n';
  os << indent << "PixelMillimeters: " << this->GetPixelMillimeters() << '\n';
}
