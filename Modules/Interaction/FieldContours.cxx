#include "FieldContours.h"

#include "FieldSampler.h"
#include "vtkSubVoxelVolumeMapper.h"

#include "vtkCellArrayIterator.h"
#include "vtkFlyingEdges2D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkVolume.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double FieldLineWidth = 1.5; // points, like those of surfaces
constexpr double SelectedFieldWidth = 3.0;

// Positive in the material; at 0 is its surface.
double MarginAt(const FieldSampler& sampler, const FieldMaterial& material, const Vector3& world)
{
  double margin = 0.0;
  for (int c = 0; c < material.ConditionCount; ++c)
  {
    const FieldCondition& condition = material.Conditions[c];
    const FieldSample sample = sampler.ValueWorld(condition.Channel, world);
    const double own = sample.Kind == SampleKind::Outside
                           ? -1.0
                           : condition.Sign() * (sample.Value - condition.Iso);
    margin = c == 0 ? own : std::min(margin, own);
  }
  return margin;
}

// The pixels of a slice that a box (world, mm) covers, from the lower left; empty if it is not cut.
PixelGrid PixelsOf(const SlicePosition& slice, const double box[6])
{
  constexpr int Edge = 4; // two samples of the coarse contour
  PixelGrid pixels = slice.Pixels();
  Eigen::AlignedBox3d covered; // column, row, height
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 world(box[corner & 1], box[2 + (corner >> 1 & 1)], box[4 + (corner >> 2 & 1)]);
    const Vector3 offset = (world - pixels.FirstWorld) / slice.PixelMillimeters;
    covered.extend(Vector3(offset.dot(slice.Frame.RightWorld), offset.dot(slice.Frame.UpWorld),
                           offset.dot(slice.Frame.TowardsViewerWorld)));
  }
  const auto clamped = [](double place, int most)
  { return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(most))); };
  const int left = clamped(std::floor(covered.min().x()) - Edge, pixels.Width);
  const int right = clamped(std::ceil(covered.max().x()) + Edge, pixels.Width);
  const int low = clamped(std::floor(covered.min().y()) - Edge, pixels.Height);
  const int high = clamped(std::ceil(covered.max().y()) + Edge, pixels.Height);
  const bool isCut = covered.min().z() <= 0.0 && covered.max().z() >= 0.0;
  pixels.FirstWorld = pixels.PixelWorld(left, low);
  pixels.Width = isCut ? right - left : 0;
  pixels.Height = isCut ? high - low : 0;
  return pixels;
}
} // namespace

std::vector<SurfaceCurve> ContourOfField(const std::shared_ptr<const ScalarField>& field,
                                         int material, const PixelGrid& pixels)
{
  const int step = pixels.Width * pixels.Height > MostFieldSamples ? 2 : 1; // pixels
  const int columns = pixels.Width / step + 1;
  const int rows = pixels.Height / step + 1;
  std::vector<SurfaceCurve> curves;
  if (field == nullptr || material >= field->MaterialCount() || pixels.Width < 1 ||
      pixels.Height < 1)
  {
    return curves;
  }
  const FieldSampler sampler(field);
  vtkNew<vtkImageData> margins;
  margins->SetDimensions(columns, rows, 1);
  margins->AllocateScalars(VTK_FLOAT, 1);
  auto* margin = static_cast<float*>(margins->GetScalarPointer());
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const Vector3 world = pixels.PixelWorld(step * column, step * row);
      *margin++ = static_cast<float>(MarginAt(sampler, field->Material(material), world));
    }
  }
  vtkNew<vtkFlyingEdges2D> edges;
  edges->SetInputData(margins);
  edges->SetValue(0, 0.0);
  edges->ComputeScalarsOff();
  edges->Update();
  vtkPolyData* found = edges->GetOutput();
  const auto place = [&](vtkIdType point)
  {
    const double* at = found->GetPoint(point);
    return pixels.PixelWorld(step * at[0], step * at[1]);
  };
  const auto lines = vtk::TakeSmartPointer(found->GetLines()->NewIterator());
  for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    lines->GetCurrentCell(count, points);
    curves.push_back({{place(points[0]), place(points[1])}, false});
  }
  return curves;
}

void FieldContours::Update(const SlicePosition& slice)
{
  for (Entry& contour : this->Entries)
  {
    auto* mapper = vtkSubVoxelVolumeMapper::SafeDownCast(contour.Of->GetMapper());
    const auto field = mapper != nullptr ? mapper->GetField() : nullptr;
    const bool isShown = field != nullptr && contour.Of->GetVisibility() != 0;
    contour.Curves->SetVisible(isShown);
    if (!isShown)
    {
      continue;
    }
    std::array<double, 3> color{};
    mapper->GetMaterialColor(0, color.data());
    contour.Curves->SetStyle(
        color, 1.0,
        (mapper->GetOutlineWidth() > 0.0 ? SelectedFieldWidth : FieldLineWidth) *
            slice.PointPixels);
    const PixelGrid pixels = PixelsOf(slice, contour.Of->GetBounds());
    if (field != contour.Last.Field || pixels != contour.Last.Pixels)
    {
      contour.Curves->SetCurves(ContourOfField(field, 0, pixels), slice.Lift(ContourLayer));
      contour.Last = {field, pixels};
      ++this->Cuts;
    }
  }
}
} // namespace palpate
