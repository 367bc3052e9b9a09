#include "vtkSubVoxelVolumeMapper.h"

#include "DepthImage.h"
#include "FieldOfImage.h"
#include "FieldRenderer.h"
#include "SceneView.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSubVoxelVolumeMapper);

namespace
{
// Rays of a tile visit the same bricks.
constexpr int TileSide = 16;
constexpr double MaximumSampleDistance = 4.0; // of rays while the camera moves, pixels
// Interval of abort checks, s.
constexpr double BandTime = 0.1;

// An image without scalars that bounds the field's surfaces, so that a camera reset frames an organ
// as closely as its polygons, however large the grid is.
vtkSmartPointer<vtkImageData> PlaceOf(const palpate::ScalarField& field)
{
  Eigen::AlignedBox3i box;
  for (const std::array<int, 3>& cell : field.SurfaceCells())
  {
    const Eigen::Vector3i low(cell[0], cell[1], cell[2]);
    box.extend(low);
    box.extend(low + Eigen::Vector3i::Ones());
  }
  auto image = palpate::EmptyImageOf(field.Grid());
  if (!box.isEmpty())
  {
    image->SetExtent(box.min().x(), box.max().x(), box.min().y(), box.max().y(), box.min().z(),
                     box.max().z());
  }
  return image;
}
} // namespace

struct vtkSubVoxelVolumeMapper::State
{
  std::vector<double> IsoValues;
  std::vector<palpate::MaterialLook> Looks;
  palpate::ContactMark Contact;
  std::shared_ptr<const palpate::ScalarField> Given;
  std::shared_ptr<const palpate::ScalarField> Made;
  vtkTimeStamp SettingsTime; ///< of the settings that the field is built from
  vtkTimeStamp MadeTime;
  palpate::DepthImage Drawing;
  double SecondsPerRay = 0.0; ///< of the last frame

  palpate::MaterialLook& Look(int material)
  {
    const auto index = static_cast<std::size_t>(std::max(0, material));
    if (this->Looks.size() <= index)
    {
      this->Looks.resize(index + 1);
    }
    return this->Looks[index];
  }
};

vtkSubVoxelVolumeMapper::vtkSubVoxelVolumeMapper()
    : Inner(std::make_unique<State>()), RasterImage(std::make_unique<palpate::FieldImage>())
{
}

vtkSubVoxelVolumeMapper::~vtkSubVoxelVolumeMapper() = default;

void vtkSubVoxelVolumeMapper::SetNumberOfIsoValues(int count)
{
  if (count >= 0 && count != this->GetNumberOfIsoValues())
  {
    this->Inner->IsoValues.resize(static_cast<std::size_t>(count), 0.0);
    this->Inner->SettingsTime.Modified();
    this->Modified();
  }
}

int vtkSubVoxelVolumeMapper::GetNumberOfIsoValues()
{
  return static_cast<int>(this->Inner->IsoValues.size());
}

void vtkSubVoxelVolumeMapper::SetIsoValue(int material, double value)
{
  if (material < 0)
  {
    return;
  }
  this->SetNumberOfIsoValues(std::max(material + 1, this->GetNumberOfIsoValues()));
  double& iso = this->Inner->IsoValues[static_cast<std::size_t>(material)];
  if (iso != value)
  {
    iso = value;
    this->Inner->SettingsTime.Modified();
    this->Modified();
  }
}

void vtkSubVoxelVolumeMapper::SetInterpolation(int interpolation)
{
  const int chosen = std::clamp<int>(interpolation, TRILINEAR, TRICUBIC);
  if (this->Interpolation != chosen)
  {
    this->Interpolation = chosen;
    this->Inner->SettingsTime.Modified();
    this->Modified();
  }
}

void vtkSubVoxelVolumeMapper::SetField(std::shared_ptr<const palpate::ScalarField> field)
{
  if (this->Inner->Given == field)
  {
    return;
  }
  // A prop without input is neither drawn nor included in a camera reset.
  this->SetInputData(field ? PlaceOf(*field) : nullptr);
  this->Inner->Given = std::move(field);
  this->Modified();
}

std::shared_ptr<const palpate::ScalarField> vtkSubVoxelVolumeMapper::GetField()
{
  if (this->Inner->Given)
  {
    return this->Inner->Given;
  }
  return this->UpdateField(nullptr) ? this->Inner->Made : nullptr;
}

void vtkSubVoxelVolumeMapper::SetMaterialColor(int material, double red, double green, double blue)
{
  this->Inner->Look(material).Color = palpate::Vector3(red, green, blue);
  this->Modified();
}

void vtkSubVoxelVolumeMapper::GetMaterialColor(int material, double color[3])
{
  const palpate::Vector3& found = this->Inner->Look(material).Color;
  std::copy_n(found.data(), 3, color);
}

void vtkSubVoxelVolumeMapper::SetMaterialOpacity(int material, double opacity)
{
  this->Inner->Look(material).Opacity = std::clamp(opacity, 0.0, 1.0);
  this->Modified();
}

double vtkSubVoxelVolumeMapper::GetMaterialOpacity(int material)
{
  return this->Inner->Look(material).Opacity;
}

void vtkSubVoxelVolumeMapper::SetContact(const palpate::ContactMark& contact)
{
  if (!(contact == this->Inner->Contact))
  {
    this->Inner->Contact = contact;
    this->Modified();
  }
}

bool vtkSubVoxelVolumeMapper::IsOpaque()
{
  const auto& looks = this->Inner->Looks;
  return std::all_of(looks.begin(), looks.end(),
                     [](const palpate::MaterialLook& look)
                     { return look.Opacity <= 0.0 || look.Opacity >= 1.0; });
}

bool vtkSubVoxelVolumeMapper::UpdateField(vtkRenderWindow* window)
{
  State& inner = *this->Inner;
  if (inner.Given)
  {
    return true;
  }
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm()->Update();
  }
  auto* image = vtkImageData::SafeDownCast(this->GetInput());
  if (image == nullptr)
  {
    vtkErrorMacro("There is nothing to draw; set an input image or a field.");
    return false;
  }
  const vtkMTimeType wanted = std::max(image->GetMTime(), inner.SettingsTime.GetMTime());
  if (inner.MadeTime.GetMTime() > wanted)
  {
    return inner.Made != nullptr;
  }
  inner.Made.reset();
  this->SetAbortExecute(0);
  bool isAborted = false;
  const auto progress = [&](double part)
  {
    this->UpdateProgress(part);
    isAborted =
        this->GetAbortExecute() != 0 || (window != nullptr && window->CheckAbortStatus() != 0);
    return !isAborted;
  };
  const auto interpolation = this->Interpolation == TRICUBIC
                                 ? palpate::FieldInterpolation::TricubicBSpline
                                 : palpate::FieldInterpolation::Trilinear;
  const palpate::Status status =
      palpate::BuildFieldOfImage(image, inner.IsoValues, interpolation, progress, inner.Made);
  if (isAborted)
  {
    return false; // restarted at the next request
  }
  inner.MadeTime.Modified();
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
  }
  return status.IsOk();
}

double vtkSubVoxelVolumeMapper::ChooseSampleDistance(vtkVolume* volume, double pixels)
{
  if (this->AutoAdjustSampleDistances)
  {
    const double allowed = std::max(1e-4, volume->GetAllocatedRenderTime());
    const double needed = std::sqrt(this->Inner->SecondsPerRay * pixels / allowed);
    this->ImageSampleDistance = std::clamp(needed, 1.0, MaximumSampleDistance);
  }
  return this->ImageSampleDistance;
}

std::unique_ptr<palpate::FieldRenderer> vtkSubVoxelVolumeMapper::MakeRenderer(vtkRenderer* renderer,
                                                                              vtkVolume* volume,
                                                                              int width, int height,
                                                                              bool readsSceneDepths)
{
  const auto field = this->GetField();
  palpate::FieldView view = palpate::MakeSceneView(renderer, volume, this, width, height);
  view.Looks = this->Inner->Looks;
  view.Contact = this->Inner->Contact;
  if (readsSceneDepths)
  {
    view.SceneDepths = palpate::ReadSceneDepths(renderer, width, height);
  }
  return std::make_unique<palpate::FieldRenderer>(field, std::move(view));
}

bool vtkSubVoxelVolumeMapper::CastRays(vtkRenderer* renderer)
{
  const palpate::FieldRenderer& caster = *this->Caster;
  palpate::FieldImage& raster = *this->RasterImage;
  const int columns = (raster.Width + TileSide - 1) / TileSide;
  const int rows = (raster.Height + TileSide - 1) / TileSide;
  const auto drawTiles = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType tile = first; tile < last; ++tile)
    {
      const int column = static_cast<int>(tile % columns) * TileSide;
      const int row = static_cast<int>(tile / columns) * TileSide;
      caster.DrawTile(column, std::min(raster.Width, column + TileSide), row,
                      std::min(raster.Height, row + TileSide), raster);
    }
  };
  const double expected = this->Inner->SecondsPerRay * raster.Width * raster.Height;
  const int bands = std::clamp(static_cast<int>(expected / BandTime), 1, rows);
  for (int band = 0; band < bands; ++band)
  {
    double part = static_cast<double>(band) / bands;
    this->InvokeEvent(vtkCommand::VolumeMapperRenderProgressEvent, &part);
    if (renderer->GetRenderWindow()->CheckAbortStatus() != 0)
    {
      return false;
    }
    vtkSMPTools::For(static_cast<vtkIdType>(rows) * band / bands * columns,
                     static_cast<vtkIdType>(rows) * (band + 1) / bands * columns, drawTiles);
  }
  return true;
}

void vtkSubVoxelVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (!this->UpdateField(renderer->GetRenderWindow()))
  {
    return;
  }
  int size[2];
  int corner[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &corner[0], &corner[1]);
  const double distance = this->ChooseSampleDistance(volume, 1.0 * size[0] * size[1]);
  const int width = std::max(1, static_cast<int>(std::lround(size[0] / distance)));
  const int height = std::max(1, static_cast<int>(std::lround(size[1] / distance)));
  const bool isOpaque = this->IsOpaque();
  this->Caster = this->MakeRenderer(renderer, volume, width, height, !isOpaque);
  if (!this->Caster->View().Rays.IsUsable())
  {
    return;
  }
  this->RasterImage->Resize(width, height, this->KeepHits);

  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
  const double start = vtkTimerLog::GetUniversalTime();
  const bool isWhole = this->CastRays(renderer);
  if (isWhole)
  {
    this->TimeToDraw = vtkTimerLog::GetUniversalTime() - start;
    this->Inner->SecondsPerRay = this->TimeToDraw / (1.0 * width * height);
    this->Inner->Drawing.SetOutline(palpate::Vector3(this->OutlineColor),
                                    this->OutlineWidth / size[0], this->OutlineWidth / size[1]);
    this->Inner->Drawing.Draw(renderer, *this->RasterImage, isOpaque);
  }
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, nullptr);
}

bool vtkSubVoxelVolumeMapper::PickSurface(vtkRenderer* renderer, vtkVolume* volume, double x,
                                          double y, SurfacePoint& point)
{
  if (!this->GetField())
  {
    return false;
  }
  int size[2];
  int corner[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &corner[0], &corner[1]);
  const auto caster = this->MakeRenderer(renderer, volume, size[0], size[1], false);
  const palpate::FieldView& view = caster->View();
  if (!view.Rays.IsUsable())
  {
    return false;
  }
  const palpate::FieldHit hit = caster->FirstHitAt(x - corner[0] + 0.5, y - corner[1] + 0.5);
  if (hit.Material < 0)
  {
    return false;
  }
  const palpate::Vector3 position = (view.ToScene * hit.Position.homogeneous()).hnormalized();
  const palpate::Vector3 normal =
      -(view.ToScene.topLeftCorner<3, 3>().inverse().transpose() * hit.Gradient).normalized();
  std::copy_n(position.data(), 3, point.Position);
  std::copy_n(normal.data(), 3, point.Normal);
  point.Depth = view.Rays.Depth(hit.Position);
  point.Material = hit.Material;
  return true;
}

void vtkSubVoxelVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Inner->Drawing.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkSubVoxelVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsoValues:";
  for (const double iso : this->Inner->IsoValues)
  {
    os << ' ' << iso;
  }
  os << '\n';
  os << indent << "Interpolation: " << (this->Interpolation == TRICUBIC ? "tricubic" : "trilinear")
     << '\n';
  os << indent << "Field given: " << (this->Inner->Given != nullptr) << '\n';
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << '\n';
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << '\n';
  os << indent << "KeepHits: " << this->KeepHits << '\n';
  os << indent << "OutlineWidth: " << this->OutlineWidth << '\n';
}
