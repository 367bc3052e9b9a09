#include "SceneRenderer.h"

#include "ArrayColors.h"
#include "BodyAxes.h"
#include "DisplayCheck.h"
#include "GreyWindow.h"
#include "ImageAxes.h"
#include "OwnCopy.h"
#include "SurfaceMaterial.h"
#include "SurfaceNormals.h"
#include "WindowImage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageProperty.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkSubVoxelVolume.h"
#include "vtkSubVoxelVolumeMapper.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkVolumeProperty.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

namespace palpate
{
namespace
{
// Size of the image relative to its content: margin for the letters, and for the colour bar.
constexpr double Margin = 1.16;
constexpr double BarMargin = 1.42;
// Font sizes in an image whose shorter side is ReferenceSide pixels.
constexpr double ReferenceSide = 800.0;
constexpr double LetterSize = 24.0;
constexpr double BarTextSize = 17.0;

// Some of VTK's filters and mappers ignore an image's direction matrix, so they get a copy without
// one, and the prop gets the matrix.
vtkSmartPointer<vtkImageData> WithoutPlace(vtkImageData* image)
{
  auto copy = OwnCopy(image);
  copy->SetOrigin(0.0, 0.0, 0.0);
  const double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  copy->SetDirectionMatrix(identity);
  return copy;
}

vtkSmartPointer<vtkMatrix4x4> PlaceOf(const ImageAxes& axes)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      matrix->SetElement(row, axis, axes.UnitWorld[axis][row]);
    }
    matrix->SetElement(row, 3, axes.OriginWorld[row]);
  }
  return matrix;
}
} // namespace

SceneRenderer::SceneRenderer()
    : Renderer(vtkSmartPointer<vtkRenderer>::New()), Window(vtkSmartPointer<vtkRenderWindow>::New())
{
  RequireDisplay();
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(4);
  this->Window->AddRenderer(this->Renderer);
  for (const SurfaceMaterial::Lamp& lamp : SurfaceMaterial::Lamps)
  {
    vtkNew<vtkLight> light;
    SurfaceMaterial::Set(light.Get(), lamp);
    this->Renderer->AddLight(light);
  }
  this->SetBackground(this->Background);
}

SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::SetBackground(const Color& color)
{
  this->Background = color;
  this->Renderer->SetBackground(color[0], color[1], color[2]);
}

void SceneRenderer::AddSurface(vtkPolyData* surface, const Color& color, double opacity)
{
  const vtkSmartPointer<vtkPolyData> shown = WithNormals(surface);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shown);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  SurfaceMaterial::Set(actor->GetProperty());
  actor->GetProperty()->SetOpacity(opacity);
  this->Renderer->AddActor(actor);
  this->Surfaces.push_back({actor, shown});
  for (vtkIdType p = 0; p < shown->GetNumberOfPoints(); ++p)
  {
    double point[3];
    shown->GetPoint(p, point);
    this->Outline.emplace_back(point);
  }
  if (opacity < 1.0)
  {
    // Depth peeling loses translucent geometry with multi-sampling.
    this->Window->SetMultiSamples(0);
    this->Window->SetAlphaBitPlanes(1);
    this->Renderer->SetUseDepthPeeling(1);
  }
}

void SceneRenderer::AddField(const std::shared_ptr<const ScalarField>& field,
                             const std::vector<Color>& colors, double opacity)
{
  vtkNew<vtkSubVoxelVolumeMapper> mapper;
  mapper->SetField(field);
  mapper->AutoAdjustSampleDistancesOff();
  for (std::size_t m = 0; m < colors.size(); ++m)
  {
    const auto material = static_cast<int>(m);
    mapper->SetMaterialColor(material, colors[m][0], colors[m][1], colors[m][2]);
    mapper->SetMaterialOpacity(material, opacity);
  }
  vtkNew<vtkSubVoxelVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->ShadeOn();
  SurfaceMaterial::Set(volume->GetProperty());
  this->Renderer->AddVolume(volume);
  for (const std::array<int, 3>& cell : field->SurfaceCells())
  {
    this->Outline.push_back(
        field->Grid().PointWorld(Vector3(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5)));
  }
}

void SceneRenderer::AddSlice(vtkImageData* volume, Plane plane, const Vector3& throughWorld)
{
  const ImageAxes axes(volume);
  const int axis = BodyAxes(axes).Axis[static_cast<std::size_t>(plane)];
  const int slice = static_cast<int>(std::lround(axes.ToIndex(throughWorld)[axis]));
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(WithoutPlace(volume));
  mapper->SetOrientation(axis);
  mapper->SetSliceNumber(std::clamp(slice, axes.Extent[2 * axis], axes.Extent[2 * axis + 1]));
  mapper->BorderOn();
  const GreyWindow window = WindowOf(volume);
  vtkNew<vtkImageSlice> shown;
  shown->SetMapper(mapper);
  shown->SetUserMatrix(PlaceOf(axes));
  shown->GetProperty()->SetColorWindow(window.High - window.Low);
  shown->GetProperty()->SetColorLevel(0.5 * (window.High + window.Low));
  this->Renderer->AddViewProp(shown);
  for (int corner = 0; corner < 4; ++corner)
  {
    Vector3 index;
    index[axis] = mapper->GetSliceNumber();
    for (int side = 0; side < 2; ++side)
    {
      const int across = (axis + 1 + side) % 3;
      const bool isHigh = (corner >> side & 1) != 0;
      index[across] = axes.Extent[2 * across + (isHigh ? 1 : 0)] + (isHigh ? 0.5 : -0.5);
    }
    this->Outline.push_back(axes.ToWorld(index));
  }
}

std::array<double, 2> SceneRenderer::RangeOf(const std::string& name) const
{
  std::array<double, 2> range{{0.0, 0.0}};
  for (const Surface& surface : this->Surfaces)
  {
    if (vtkDataArray* values = surface.Data->GetPointData()->GetArray(name.c_str()))
    {
      double own[2];
      values->GetFiniteRange(own);
      range[0] = std::min(range[0], own[0]);
      range[1] = std::max(range[1], own[1]);
    }
  }
  return range;
}

bool SceneRenderer::ColorByArray(const std::string& name)
{
  const std::array<double, 2> range = this->RangeOf(name);
  const vtkSmartPointer<vtkLookupTable> table = MakeArrayColors(range[0], range[1]);
  bool isFound = false;
  for (const Surface& surface : this->Surfaces)
  {
    vtkDataArray* values = surface.Data->GetPointData()->GetArray(name.c_str());
    if (values && values->GetNumberOfComponents() == 1)
    {
      vtkMapper* mapper = surface.Actor->GetMapper();
      mapper->ScalarVisibilityOn();
      mapper->SetScalarModeToUsePointFieldData();
      mapper->SelectColorArray(name.c_str());
      mapper->SetLookupTable(table);
      mapper->UseLookupTableScalarRangeOn();
      mapper->InterpolateScalarsBeforeMappingOn();
      isFound = true;
    }
  }
  if (isFound)
  {
    this->BarColors = table;
    this->ColoredArray = name;
  }
  return isFound;
}

std::vector<std::string> SceneRenderer::ArrayNames() const
{
  std::set<std::string> names;
  for (const Surface& surface : this->Surfaces)
  {
    vtkPointData* data = surface.Data->GetPointData();
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = data->GetArray(a);
      if (array && array->GetName() && array->GetNumberOfComponents() == 1)
      {
        names.insert(array->GetName());
      }
    }
  }
  return {names.begin(), names.end()};
}

Vector3 SceneRenderer::CenterWorld() const
{
  Eigen::AlignedBox3d box;
  for (const Vector3& point : this->Outline)
  {
    box.extend(point);
  }
  return box.isEmpty() ? Vector3(Vector3::Zero()) : Vector3(box.center());
}

void SceneRenderer::PlaceCamera(const ViewFrame& frame, double aspect)
{
  Eigen::Matrix3d axes; // of the view: right, up, towards the viewer
  axes << frame.RightWorld, frame.UpWorld, frame.TowardsViewerWorld;
  Eigen::AlignedBox3d box;
  for (const Vector3& point : this->Outline)
  {
    box.extend(Vector3(axes.transpose() * point));
  }
  if (box.isEmpty())
  {
    box.extend(Vector3(Vector3::Zero()));
  }
  const double largest = 0.5 * box.sizes().maxCoeff();
  const Vector3 half = (0.5 * box.sizes()).cwiseMax(largest > 0.0 ? 1e-3 * largest : 1.0);
  const Vector3 middle = axes * box.center();
  const Vector3 eye = middle + 3.0 * half.norm() * frame.TowardsViewerWorld;
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(middle.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(frame.UpWorld.data());
  camera->SetParallelScale((this->BarColors ? BarMargin : Margin) *
                           std::max(half.y(), half.x() / aspect));
  this->Renderer->ResetCameraClippingRange();
}

SceneRenderer::Color SceneRenderer::InkColor() const
{
  const double luminance =
      0.3 * this->Background[0] + 0.6 * this->Background[1] + 0.1 * this->Background[2];
  return luminance > 0.5 ? Color{{0.1, 0.1, 0.1}} : Color{{0.95, 0.95, 0.95}};
}

int SceneRenderer::FontSize(double referenceSize) const
{
  const int* size = this->Window->GetSize();
  return std::max(9, static_cast<int>(referenceSize * std::min(size[0], size[1]) / ReferenceSide));
}

void SceneRenderer::AddLetters(const ViewFrame& frame)
{
  const Color ink = this->InkColor();
  const auto add = [&](const std::string& letters, double x, double y)
  {
    vtkNew<vtkTextActor> text;
    text->SetInput(letters.c_str());
    vtkTextProperty* style = text->GetTextProperty();
    style->SetFontSize(this->FontSize(LetterSize));
    style->BoldOn();
    style->SetColor(ink[0], ink[1], ink[2]);
    style->SetJustification(x < 0.3 ? VTK_TEXT_LEFT : x > 0.7 ? VTK_TEXT_RIGHT : VTK_TEXT_CENTERED);
    style->SetVerticalJustification(y < 0.3   ? VTK_TEXT_BOTTOM
                                    : y > 0.7 ? VTK_TEXT_TOP
                                              : VTK_TEXT_CENTERED);
    text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    text->SetPosition(x, y);
    this->Annotate(text);
  };
  const auto [left, right, top, bottom] = EdgeLettersOf(frame);
  add(left, 0.012, 0.5);
  add(right, 0.988, 0.5);
  add(top, 0.5, 0.985);
  add(bottom, this->BarColors ? 0.6 : 0.5, 0.015);
}

void SceneRenderer::Annotate(vtkProp* prop)
{
  this->Renderer->AddViewProp(prop);
  this->Annotations.emplace_back(prop);
}

void SceneRenderer::AddColorBar()
{
  const Color ink = this->InkColor();
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(this->BarColors);
  bar->SetNumberOfLabels(3);
  bar->SetLabelFormat("%.3g");
  bar->SetMaximumNumberOfColors(static_cast<int>(this->BarColors->GetNumberOfAvailableColors()));
  bar->UnconstrainedFontSizeOn();
  bar->SetOrientationToHorizontal();
  bar->SetTextPositionToPrecedeScalarBar();
  bar->SetPosition(0.05, 0.02);
  bar->SetPosition2(0.42, 0.08);
  // The bar's own title would overlap its labels.
  vtkNew<vtkTextActor> title;
  title->SetInput(ArrayTitle(this->ColoredArray).c_str());
  title->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  title->SetPosition(0.055, 0.115);
  for (vtkTextProperty* style : {title->GetTextProperty(), bar->GetLabelTextProperty()})
  {
    style->SetColor(ink[0], ink[1], ink[2]);
    style->SetFontSize(this->FontSize(BarTextSize));
    style->BoldOff();
    style->ItalicOff();
    style->ShadowOff();
  }
  this->Annotate(bar);
  this->Annotate(title);
}

void SceneRenderer::RemoveAnnotations()
{
  for (const vtkSmartPointer<vtkProp>& prop : this->Annotations)
  {
    this->Renderer->RemoveViewProp(prop);
  }
  this->Annotations.clear();
}

RasterImage SceneRenderer::Render(const ViewFrame& frame, int width, int height)
{
  this->RemoveAnnotations();
  this->Window->SetSize(width, height);
  this->AddLetters(frame);
  if (this->BarColors)
  {
    this->AddColorBar();
  }
  this->PlaceCamera(frame, static_cast<double>(width) / height);
  this->Window->Render();
  return ReadWindow(this->Window);
}
} // namespace palpate
