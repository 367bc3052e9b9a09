#include "RenderBenchmarks.h"

#include "vtkSubVoxelVolume.h"
#include "vtkSubVoxelVolumeMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <functional>
#include <memory>
#include <sstream>

namespace palpate::bench
{
namespace
{
constexpr int RenderNodes = 256;
constexpr float Iso = 0.0F;

// A smooth, bumpy body that fills most of the picture.
vtkSmartPointer<vtkImageData> MakeBody()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(RenderNodes, RenderNodes, RenderNodes);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(image->GetScalarPointer());
  const auto place = [](int index) { return 2.0 * index / (RenderNodes - 1) - 1.0; };
  for (int k = 0; k < RenderNodes; ++k)
  {
    for (int j = 0; j < RenderNodes; ++j)
    {
      for (int i = 0; i < RenderNodes; ++i)
      {
        const double bumps =
            0.1 * std::sin(7.0 * place(i)) * std::cos(6.0 * place(j)) * std::sin(5.0 * place(k));
        *value++ = static_cast<float>(0.8 + bumps - std::hypot(place(i), place(j), place(k)));
      }
    }
  }
  return image;
}

// A window of its own, turned a little for every frame.
class Scene
{
public:
  explicit Scene(int side, vtkProp* prop) : Side(side)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(side, side);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(0.0, 0.0, 1.0);
    this->Renderer->AddViewProp(prop);
    const double bounds[6] = {0.0, RenderNodes - 1.0, 0.0, RenderNodes - 1.0,
                              0.0, RenderNodes - 1.0};
    this->Renderer->ResetCamera(bounds);
    this->Renderer->GetActiveCamera()->Zoom(1.6);
  }

  void Frame()
  {
    this->Renderer->GetActiveCamera()->Azimuth(3.0);
    this->Window->Render();
  }
  // Whether each pixel shows the body.
  std::vector<bool> Silhouette()
  {
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, this->Side - 1, this->Side - 1, 0, pixels);
    std::vector<bool> shown;
    for (vtkIdType pixel = 0; pixel < pixels->GetNumberOfTuples(); ++pixel)
    {
      shown.push_back(pixels->GetTypedComponent(pixel, 2) != 255);
    }
    return shown;
  }

private:
  int Side;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

vtkSmartPointer<vtkProp> SubVoxelProp(vtkImageData* body)
{
  vtkNew<vtkSubVoxelVolumeMapper> mapper;
  mapper->SetInputData(body);
  mapper->SetIsoValue(0, Iso);
  mapper->AutoAdjustSampleDistancesOff();
  auto volume = vtkSmartPointer<vtkSubVoxelVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->ShadeOn();
  return volume;
}

vtkSmartPointer<vtkProp> PolygonProp(vtkImageData* body)
{
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(body);
  edges->SetValue(0, Iso);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(edges->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

// Opaque from the iso-value on, one sample a voxel, shaded.
vtkSmartPointer<vtkProp> StockVolume(vtkVolumeMapper* mapper, vtkImageData* body)
{
  mapper->SetInputData(body);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(Iso - 0.004, 0.0);
  opacity->AddPoint(Iso + 0.004, 1.0);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(Iso, 0.9, 0.85, 0.75);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  volume->GetProperty()->ShadeOn();
  return volume;
}

vtkSmartPointer<vtkProp> FixedPointProp(vtkImageData* body)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(1.0F);
  mapper->SetImageSampleDistance(1.0F);
  return StockVolume(mapper, body);
}

using MakeProp = std::function<vtkSmartPointer<vtkProp>(vtkImageData*)>;

// Made when it is first run: bodies and windows are many megabytes.
class RenderCase
{
public:
  RenderCase(int side, MakeProp ours, MakeProp theirs)
      : Side(side), MakeOurs(std::move(ours)), MakeTheirs(std::move(theirs))
  {
  }

  void Ours() { this->Frame(this->First, this->MakeOurs); }
  void Theirs() { this->Frame(this->Second, this->MakeTheirs); }

  // Stock volume mappers are up to a sample off at silhouettes, and see none of the thinnest rims.
  std::string Disagreement()
  {
    const std::vector<bool> ours = this->First->Silhouette();
    const std::vector<bool> theirs = this->Second->Silhouette();
    std::size_t shown = 0;
    std::size_t different = 0;
    for (std::size_t pixel = 0; pixel < ours.size(); ++pixel)
    {
      shown += ours[pixel] ? 1 : 0;
      different += ours[pixel] != theirs[pixel] ? 1 : 0;
    }
    if (4 * shown > ours.size() && 30 * different < shown)
    {
      return {};
    }
    std::ostringstream text;
    text << different << " of " << shown << " pixels differ";
    return text.str();
  }

private:
  void Frame(std::unique_ptr<Scene>& scene, const MakeProp& make)
  {
    if (!scene)
    {
      scene = std::make_unique<Scene>(this->Side, make(MakeBody()));
    }
    scene->Frame();
  }

  int Side;
  MakeProp MakeOurs;
  MakeProp MakeTheirs;
  std::unique_ptr<Scene> First;
  std::unique_ptr<Scene> Second;
};

PairedBenchmark RenderPair(const std::string& name, const std::string& against, int side,
                           const MakeProp& theirs)
{
  const auto c = std::make_shared<RenderCase>(side, SubVoxelProp, theirs);
  PairedBenchmark pair{name, against, [c] { c->Ours(); }, [c] { c->Theirs(); },
                       [c] { return c->Disagreement(); }};
  pair.IsCounted = false;
  return pair;
}
} // namespace

std::vector<PairedBenchmark> RenderBenchmarks()
{
  const std::string polygons = "vtkFlyingEdges3D's polygons";
  const std::string fixedPoint = "vtkFixedPointVolumeRayCastMapper, shaded, a sample a voxel";
  return {RenderPair("render/subvoxel/512", polygons, 512, PolygonProp),
          RenderPair("render/subvoxel/512/fixedpoint", fixedPoint, 512, FixedPointProp),
          RenderPair("render/subvoxel/1024", polygons, 1024, PolygonProp),
          RenderPair("render/subvoxel/1024/fixedpoint", fixedPoint, 1024, FixedPointProp)};
}
} // namespace palpate::bench
