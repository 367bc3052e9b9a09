#include "ViewBenchmarks.h"

#include "FourViews.h"
#include "ImageAxes.h"
#include "RasterImage.h"
#include "SlicePosition.h"
#include "VolumeColors.h"
#include "VolumeFile.h"
#include "WindowImage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCutter.h"
#include "vtkImageProperty.h"
#include "vtkImageResliceMapper.h"
#include "vtkImageSlice.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

namespace palpate::bench
{
namespace
{
constexpr const char* BrainFile = "/usr/share/mricron/templates/ch2.nii.gz";     // Colin 27
constexpr const char* SecondFile = "/usr/share/mricron/templates/ch2bet.nii.gz"; // its brain
constexpr int Width = 1280;
constexpr int Height = 800;

// A structure as large as a lobe, of as many triangles as the surface of a segmentation has.
vtkSmartPointer<vtkPolyData> StructureSurface()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(35.0);
  sphere->SetCenter(8.0, -10.0, 12.0);
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(200);
  sphere->Update();
  return sphere->GetOutput();
}

// A way through the brain, a little further in every frame.
Vector3 PlaceOf(int frame)
{
  const double angle = 0.13 * frame;
  return {12.0 * std::sin(angle), 15.0 * std::cos(0.7 * angle) - 10.0,
          10.0 + 9.0 * std::sin(0.9 * angle)};
}

class OurViews
{
public:
  OurViews(vtkImageData* image, vtkPolyData* surface) : Views(image, Width, Height)
  {
    vtkNew<vtkSurfaceDisplay> display;
    display->SetSurface(surface);
    this->Views.AddSurface(display);
    this->Views.Probe->VisibilityOn();
    this->Views.Probe->SetForce(0.5, 0.0, 0.0);
  }
  void Frame(int frame)
  {
    const Vector3 place = PlaceOf(frame);
    this->Views.Crosshair->SetPositionWorld(place.data());
    this->Views.Probe->SetProbePosition(place.x(), place.y(), place.z());
    this->Views.Probe->SetProxyPosition(place.x(), place.y(), place.z());
    this->Views.Render();
  }

  void Blend(vtkImageData* over)
  {
    const int overlay = this->Views.Images->AddOverlay(over);
    this->Views.Images->SetOverlayColors(overlay, static_cast<int>(VolumeColors::Hot));
  }

  test::FourViews Views;
};

// What VTK's examples do: a reslice mapper for each view's slice and for each slice in space, a
// cutter for each contour.
class StockViews
{
public:
  StockViews(vtkImageData* image, vtkPolyData* surface, OurViews& ours) : Ours(ours)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Width, Height);
    const ImageAxes axes(image);
    this->Image->ShallowCopy(image);
    this->Image->SetOrigin(0.0, 0.0, 0.0);
    const double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    this->Image->SetDirectionMatrix(identity);
    for (int row = 0; row < 3; ++row)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Place->SetElement(row, axis, axes.UnitWorld[static_cast<std::size_t>(axis)][row]);
      }
      this->Place->SetElement(row, 3, axes.OriginWorld[row]);
    }
    this->Space = this->AddRenderer(ours.Views.Space->GetRenderer());
    for (std::size_t slice = 0; slice < 3; ++slice)
    {
      this->Slices[slice] = this->AddRenderer(ours.Views.Slices[slice]->GetRenderer());
      this->AddImage(this->Slices[slice])->SliceAtFocalPointOn();
      this->AddImage(this->Space)->SetSlicePlane(this->Planes[slice]);
      this->AddContour(surface, slice);
    }
    this->AddSurface(surface);
  }
  // Along the same planes, under the same cameras.
  void Frame(int frame)
  {
    const Vector3 place = PlaceOf(frame);
    for (std::size_t slice = 0; slice < 3; ++slice)
    {
      vtkSliceView* like = this->Ours.Views.Slices[slice];
      Vector3 normal = like->GetPosition().Frame.TowardsViewerWorld;
      this->Planes[slice]->SetOrigin(place.data());
      this->Planes[slice]->SetNormal(normal.data());
      this->Slices[slice]->GetActiveCamera()->DeepCopy(like->GetRenderer()->GetActiveCamera());
      Vector3 focus(this->Slices[slice]->GetActiveCamera()->GetFocalPoint());
      const Vector3 path = (place - focus).dot(normal) * normal;
      const Vector3 eye = Vector3(this->Slices[slice]->GetActiveCamera()->GetPosition()) + path;
      focus += path;
      this->Slices[slice]->GetActiveCamera()->SetFocalPoint(focus.data());
      this->Slices[slice]->GetActiveCamera()->SetPosition(eye.data());
    }
    this->Space->GetActiveCamera()->DeepCopy(
        this->Ours.Views.Space->GetRenderer()->GetActiveCamera());
    this->Window->Render();
  }

  vtkNew<vtkRenderWindow> Window;

private:
  vtkSmartPointer<vtkRenderer> AddRenderer(vtkRenderer* like)
  {
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->SetViewport(like->GetViewport());
    this->Window->AddRenderer(renderer);
    return renderer;
  }
  vtkImageResliceMapper* AddImage(vtkRenderer* renderer)
  {
    vtkNew<vtkImageResliceMapper> mapper;
    mapper->SetInputData(this->Image);
    mapper->SliceFacesCameraOff();
    if (renderer != this->Space)
    {
      mapper->SliceFacesCameraOn();
    }
    vtkNew<vtkImageSlice> slice;
    slice->SetMapper(mapper);
    slice->SetUserMatrix(this->Place);
    slice->GetProperty()->SetColorWindow(this->Ours.Views.Images->GetWindow());
    slice->GetProperty()->SetColorLevel(this->Ours.Views.Images->GetLevel());
    renderer->AddViewProp(slice);
    return mapper;
  }
  void AddContour(vtkPolyData* surface, std::size_t slice)
  {
    vtkNew<vtkCutter> cutter;
    cutter->SetInputData(surface);
    cutter->SetCutFunction(this->Planes[slice]);
    this->AddPolygons(this->Slices[slice], cutter->GetOutputPort());
  }
  void AddSurface(vtkPolyData* surface)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Space->AddActor(actor);
  }
  void AddPolygons(vtkRenderer* renderer, vtkAlgorithmOutput* output)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(output);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    renderer->AddActor(actor);
  }

  OurViews& Ours;
  vtkNew<vtkImageData> Image;
  vtkNew<vtkMatrix4x4> Place;
  std::array<vtkNew<vtkPlane>, 3> Planes;
  std::array<vtkSmartPointer<vtkRenderer>, 3> Slices;
  vtkSmartPointer<vtkRenderer> Space;
};

// Made when it is first run: reading and windows are many megabytes.
class ViewCase
{
public:
  void RunOurs()
  {
    this->Prepare();
    this->Ours->Frame(++this->OurFrame);
  }
  void RunTheirs()
  {
    this->Prepare();
    this->Theirs->Frame(++this->TheirFrame);
  }
  // Slices of both show the same brain: nearly all pixels of the axial view, without its lines and
  // letters, have nearly the same grey.
  std::string Disagreement()
  {
    const int frame = 5;
    this->Ours->Frame(frame);
    this->Theirs->Frame(frame);
    const RasterImage ours = ReadWindow(this->Ours->Views.Window);
    const RasterImage theirs = ReadWindow(this->Theirs->Window);
    int different = 0;
    int bright = 0;
    for (int row = 0; row < Height / 2; ++row)
    {
      for (int column = 0; column < Width / 2; ++column)
      {
        const int a = ours.Pixel(column, row)[2];
        different += std::abs(a - theirs.Pixel(column, row)[2]) > 12 ? 1 : 0;
        bright += a > 60 ? 1 : 0;
      }
    }
    if (bright > 20000 && different < 9000)
    {
      return {};
    }
    std::ostringstream text;
    text << different << " pixels differ; " << bright << " are bright";
    return text.str();
  }

private:
  void Prepare()
  {
    if (!this->Ours)
    {
      const vtkSmartPointer<vtkImageData> brain = ReadVolume(BrainFile).Image;
      const vtkSmartPointer<vtkPolyData> surface = StructureSurface();
      this->Ours = std::make_unique<OurViews>(brain, surface);
      this->Ours->Frame(0);
      this->Theirs = std::make_unique<StockViews>(brain, surface, *this->Ours);
    }
  }

  std::unique_ptr<OurViews> Ours;
  std::unique_ptr<StockViews> Theirs;
  int OurFrame = 0;
  int TheirFrame = 0;
};
// Four views with a second volume over the first one, and without it.
class BlendCase
{
public:
  void RunBlended() { this->Prepare().Blended->Frame(++this->BlendedFrame); }
  void RunPlain() { this->Prepare().Plain->Frame(++this->PlainFrame); }
  // In the axial view the second one, a brain in colours, covers a part of the head.
  std::string Disagreement()
  {
    const int frame = 5;
    this->Prepare().Blended->Frame(frame);
    this->Plain->Frame(frame);
    const RasterImage blended = ReadWindow(this->Blended->Views.Window);
    const RasterImage plain = ReadWindow(this->Plain->Views.Window);
    int colored = 0;
    int same = 0;
    for (int row = 0; row < Height / 2; ++row)
    {
      for (int column = 0; column < Width / 2; ++column)
      {
        const std::uint8_t* pixel = blended.Pixel(column, row);
        const std::uint8_t* other = plain.Pixel(column, row);
        const bool isSame = std::equal(pixel, pixel + 3, other);
        same += isSame ? 1 : 0;
        colored += !isSame && pixel[0] != pixel[2] ? 1 : 0;
      }
    }
    if (colored > 20000 && same > 20000)
    {
      return {};
    }
    return std::to_string(colored) + " pixels are coloured; " + std::to_string(same) +
           " are as without the second volume";
  }

private:
  BlendCase& Prepare()
  {
    if (!this->Blended)
    {
      const vtkSmartPointer<vtkImageData> head = ReadVolume(BrainFile).Image;
      const vtkSmartPointer<vtkImageData> brain = ReadVolume(SecondFile).Image;
      const vtkSmartPointer<vtkPolyData> surface = StructureSurface();
      this->Blended = std::make_unique<OurViews>(head, surface);
      this->Blended->Blend(brain);
      this->Plain = std::make_unique<OurViews>(head, surface);
    }
    return *this;
  }

  std::unique_ptr<OurViews> Blended;
  std::unique_ptr<OurViews> Plain;
  int BlendedFrame = 0;
  int PlainFrame = 0;
};
} // namespace

std::vector<PairedBenchmark> ViewBenchmarks()
{
  if (!std::filesystem::exists(BrainFile))
  {
    std::cerr << "No views are timed: " << BrainFile << " is absent.\n";
    return {};
  }
  const auto c = std::make_shared<ViewCase>();
  PairedBenchmark four{"views/four", "vtkImageResliceMapper and vtkCutter for each slice",
                       [c] { c->RunOurs(); }, [c] { c->RunTheirs(); },
                       [c] { return c->Disagreement(); }};
  four.IsCounted = false;
  const auto b = std::make_shared<BlendCase>();
  PairedBenchmark second{"views/four/blended", "one volume (ours)", [b] { b->RunBlended(); },
                         [b] { b->RunPlain(); }, [b] { return b->Disagreement(); }};
  second.IsCounted = false;
  return {four, second};
}
} // namespace palpate::bench
