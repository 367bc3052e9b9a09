#include "vtkSliceView.h"

#include "CrosshairInSlice.h"
#include "FieldContours.h"
#include "ImageAxes.h"
#include "LandmarksInSlice.h"
#include "ProbeInSlice.h"
#include "SliceAnnotation.h"
#include "SliceContours.h"
#include "SliceGeometry.h"
#include "SlicePainter.h"
#include "SlicePatch.h"
#include "ViewText.h"
#include "vtkCrosshair.h"
#include "vtkImageDisplay.h"
#include "vtkLandmarks.h"
#include "vtkProbeRepresentation.h"
#include "vtkSurfaceDisplay.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <vector>

using palpate::SliceGeometry;
using palpate::SliceOrientation;
using palpate::SlicePosition;
using palpate::Vector3;

vtkStandardNewMacro(vtkSliceView);

namespace
{
constexpr double FitMargin = 1.04;     // view over volume
constexpr double SurfaceMargin = 1.25; // view over surfaces, which then miss its letters
constexpr double EyeDistance = 1000.0; // mm; any value in parallel projection
constexpr double SmallestHeight = 0.5; // of a view, mm
constexpr double SmallestFit = 1e-6;   // for what is a point
constexpr double LargestHeight = 1e5;
constexpr double EmptyHeight = 200.0; // without a volume and surfaces

bool HasImage(vtkImageDisplay* display)
{
  return display != nullptr && display->GetImage() != nullptr;
}

std::vector<Vector3> CornersOf(vtkImageData* image)
{
  const auto corners = palpate::ImageAxes(image).CornersWorld();
  return {corners.begin(), corners.end()};
}

std::vector<Vector3> CornersOf(const Eigen::AlignedBox3d& box)
{
  std::vector<Vector3> corners;
  for (int n = 0; n < 8 && !box.isEmpty(); ++n)
  {
    corners.emplace_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(n)));
  }
  return corners;
}
} // namespace

struct vtkSliceView::State
{
  bool NeedsFit = true;
  bool FitsSurfaces = false; // there is no volume, and the view was not zoomed or moved since
  Vector3 Center = Vector3::Zero(); // of the view, world; its height over the plane is ignored
  double Height = EmptyHeight;      // of the view, mm
  double FittedHeight = EmptyHeight;
  bool HadImage = false; // in the last frame

  palpate::SlicePatch Patch;
  palpate::PixelGrid PaintedGrid;
  vtkMTimeType PaintedTime = 0;
  int PaintCount = 0;
  palpate::SliceContours Contours;
  palpate::FieldContours Fields;
  palpate::LandmarksInSlice Marks;
  palpate::ProbeInSlice Tool;
  palpate::CrosshairInSlice Pointer;
  palpate::SliceAnnotation Annotation;

  SliceGeometry Geometry(vtkSliceView* view)
  {
    vtkImageDisplay* display = view->GetImageDisplay();
    SliceGeometry geometry(static_cast<SliceOrientation>(view->Orientation), view->GetAlongImage(),
                           display == nullptr ? nullptr : display->GetImage());
    if (view->Neurological && view->Orientation != SAGITTAL)
    {
      geometry.Frame.RightWorld *= -1.0;
      geometry.Frame.TowardsViewerWorld *= -1.0;
    }
    return geometry;
  }
  Vector3 Focus(vtkSliceView* view) const
  {
    vtkCrosshair* crosshair = view->GetCrosshair();
    return crosshair == nullptr ? this->Center : Vector3(crosshair->GetPositionWorld());
  }
};

vtkSliceView::vtkSliceView() : Inner(std::make_unique<State>()) {}

vtkSliceView::~vtkSliceView()
{
  this->SetRenderer(nullptr);
}

void vtkSliceView::AddTo(vtkRenderer* renderer)
{
  State& state = *this->Inner;
  renderer->AddViewProp(state.Patch.Actor());
  state.Contours.SetRenderer(renderer);
  state.Fields.SetRenderer(renderer);
  state.Marks.SetRenderer(renderer);
  state.Tool.AddTo(renderer);
  state.Pointer.AddTo(renderer);
  state.Annotation.AddTo(renderer);
}

void vtkSliceView::RemoveFrom(vtkRenderer* renderer)
{
  State& state = *this->Inner;
  renderer->RemoveViewProp(state.Patch.Actor());
  state.Contours.SetRenderer(nullptr);
  state.Fields.SetRenderer(nullptr);
  state.Marks.SetRenderer(nullptr);
  state.Tool.RemoveFrom(renderer);
  state.Pointer.RemoveFrom(renderer);
  state.Annotation.RemoveFrom(renderer);
}

void vtkSliceView::SetImageDisplay(vtkImageDisplay* display)
{
  this->Inner->NeedsFit = this->Inner->NeedsFit || display != this->GetImageDisplay();
  this->Superclass::SetImageDisplay(display);
}

void vtkSliceView::AddSurface(vtkSurfaceDisplay* surface)
{
  this->Inner->Contours.Add(surface);
  this->Inner->NeedsFit = this->Inner->NeedsFit || this->Inner->FitsSurfaces;
  this->Modified();
}

void vtkSliceView::RemoveSurface(vtkSurfaceDisplay* surface)
{
  this->Inner->Contours.Remove(surface);
  // What comes after the last one may be elsewhere.
  const bool isEmpty =
      !HasImage(this->GetImageDisplay()) && this->Inner->Contours.Bounds().isEmpty();
  this->Inner->NeedsFit = this->Inner->NeedsFit || isEmpty;
  this->Modified();
}

void vtkSliceView::AddField(vtkVolume* field)
{
  this->Inner->Fields.Add(field);
  this->Modified();
}

void vtkSliceView::RemoveField(vtkVolume* field)
{
  this->Inner->Fields.Remove(field);
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
  vtkImageDisplay* display = this->GetImageDisplay();
  vtkImageData* image = display == nullptr ? nullptr : display->GetImage();
  const int* size = this->GetRenderer()->GetSize();
  const std::vector<Vector3> corners =
      image != nullptr ? CornersOf(image) : CornersOf(state.Contours.Bounds());
  if (corners.empty() || size[0] < 1 || size[1] < 1)
  {
    return;
  }
  const palpate::ViewFrame frame = state.Geometry(this).Frame;
  Eigen::AlignedBox2d box;
  for (const Vector3& corner : corners)
  {
    box.extend(Eigen::Vector2d(corner.dot(frame.RightWorld), corner.dot(frame.UpWorld)));
  }
  const double aspect = static_cast<double>(size[0]) / size[1];
  state.Center = box.center().x() * frame.RightWorld + box.center().y() * frame.UpWorld;
  state.Height = std::max((image != nullptr ? FitMargin : SurfaceMargin) *
                              std::max(box.sizes().y(), box.sizes().x() / aspect),
                          SmallestFit);
  state.FittedHeight = state.Height;
  state.NeedsFit = false;
  state.FitsSurfaces = image == nullptr;
}

SlicePosition vtkSliceView::GetPosition()
{
  State& state = *this->Inner;
  SlicePosition position;
  position.Frame = state.Geometry(this).Frame;
  const Vector3& normal = position.Frame.TowardsViewerWorld;
  position.CenterWorld = state.Center + normal.dot(state.Focus(this) - state.Center) * normal;
  if (vtkRenderer* renderer = this->GetRenderer())
  {
    const int* size = renderer->GetSize();
    position.Width = size[0];
    position.Height = size[1];
    position.PointPixels = palpate::PointPixels(renderer);
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
  return this->Inner->Contours.CutCount() + this->Inner->Fields.CutCount();
}

double vtkSliceView::GetPixelMillimeters()
{
  return this->GetPosition().PixelMillimeters;
}

void vtkSliceView::Scroll(int slices)
{
  if (vtkCrosshair* crosshair = this->GetCrosshair())
  {
    const Vector3 moved =
        this->Inner->Geometry(this).Moved(Vector3(crosshair->GetPositionWorld()), slices);
    crosshair->SetPositionWorld(moved.data());
  }
}

int vtkSliceView::GetSliceNumber()
{
  const SliceGeometry geometry = this->Inner->Geometry(this);
  return geometry.HasNumbers() ? geometry.NumberOf(this->Inner->Focus(this)) + 1 : 0;
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
  // What is very small or large can be zoomed too.
  const double fitted = this->Inner->FittedHeight;
  this->Inner->Height =
      std::clamp(this->Inner->Height / factor, std::min(SmallestHeight, 1e-2 * fitted),
                 std::max(LargestHeight, 1e2 * fitted));
  Vector3 after;
  this->DisplayToWorld(x, y, after.data());
  this->Inner->Center += before - after;
  this->Inner->FitsSurfaces = false;
  this->Modified();
}

void vtkSliceView::Pan(double right, double up)
{
  const SlicePosition position = this->GetPosition();
  this->Inner->Center -=
      position.PixelMillimeters * (right * position.Frame.RightWorld + up * position.Frame.UpWorld);
  this->Inner->FitsSurfaces = false;
  this->Modified();
}

void vtkSliceView::ShowPoint(const double world[3])
{
  const SlicePosition position = this->GetPosition();
  const palpate::ViewFrame& frame = position.Frame;
  const Vector3 offset = Vector3(world) - position.CenterWorld;
  const double right = offset.dot(frame.RightWorld);
  const double up = offset.dot(frame.UpWorld);
  const double half = 0.5 * position.PixelMillimeters;
  if (std::abs(right) > half * position.Width || std::abs(up) > half * position.Height)
  {
    this->Inner->Center += right * frame.RightWorld + up * frame.UpWorld;
    this->Inner->FitsSurfaces = false;
    this->Modified();
  }
}

void vtkSliceView::DisplayToWorld(double x, double y, double world[3])
{
  const SlicePosition position = this->GetPosition();
  int origin[2] = {0, 0};
  if (vtkRenderer* renderer = this->GetRenderer())
  {
    std::copy_n(renderer->GetOrigin(), 2, origin);
  }
  const Vector3 point = position.ToWorld(x + 0.5 - origin[0], y + 0.5 - origin[1]);
  std::copy_n(point.data(), 3, world);
}

void vtkSliceView::MoveCrosshairTo(double x, double y)
{
  if (vtkCrosshair* crosshair = this->GetCrosshair())
  {
    double world[3];
    this->DisplayToWorld(x, y, world);
    crosshair->SetPositionWorld(world);
  }
}

void vtkSliceView::UpdateFor(vtkRenderer* renderer)
{
  State& state = *this->Inner;
  const bool hasImage = HasImage(this->GetImageDisplay());
  if (state.NeedsFit || (hasImage && !state.HadImage))
  {
    this->Fit();
  }
  state.HadImage = hasImage;
  const SlicePosition position = this->GetPosition();
  if (position.Width < 1 || position.Height < 1)
  {
    return;
  }
  this->PlaceCamera(renderer, position);
  this->UpdateImage(position);
  state.Contours.Update(position);
  state.Fields.Update(position);
  state.Marks.Update(this->GetLandmarks(), position);
  state.Tool.Update(this->GetProbe(), position, this->UnitOfLength());
  const auto orientation = static_cast<SliceOrientation>(this->Orientation);
  state.Pointer.Update(this->GetCrosshair(), orientation, position);
  state.Annotation.SetVisible(this->GetAnnotationVisibility());
  if (this->GetAnnotationVisibility())
  {
    state.Annotation.SetTitled(this->TitleVisibility);
    state.Annotation.Update(orientation, state.Geometry(this), position, state.Focus(this),
                            this->UnitOfLength());
  }
}

void vtkSliceView::PlaceCamera(vtkRenderer* renderer, const SlicePosition& position)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const Vector3 eye = position.CenterWorld + EyeDistance * position.Frame.TowardsViewerWorld;
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(position.CenterWorld.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(position.Frame.UpWorld.data());
  camera->SetParallelScale(0.5 * this->Inner->Height);
  camera->SetClippingRange(0.5 * EyeDistance, 1.5 * EyeDistance);
}

void vtkSliceView::UpdateImage(const SlicePosition& position)
{
  State& state = *this->Inner;
  vtkImageDisplay* display = this->GetImageDisplay();
  state.Patch.Actor()->SetVisibility(display != nullptr ? 1 : 0);
  if (display == nullptr)
  {
    return;
  }
  const palpate::PixelGrid grid = position.Pixels();
  const vtkMTimeType time = display->GetMTime();
  if (grid == state.PaintedGrid && time == state.PaintedTime)
  {
    return;
  }
  palpate::PaintSlice(display->GetContent(), grid, state.Patch.RasterImage());
  state.Patch.Place(grid, palpate::SlicePatch::CornersOf(grid));
  state.PaintedGrid = grid;
  state.PaintedTime = time;
  ++state.PaintCount;
}

void vtkSliceView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "Orientation: " << palpate::NameOf(static_cast<SliceOrientation>(this->Orientation))
     << '\n';
  os << indent << "Neurological: " << this->Neurological << '\n';
  os << indent << "TitleVisibility: " << this->TitleVisibility << '\n';
  os << indent << "PixelMillimeters: " << this->GetPixelMillimeters() << '\n';
}
