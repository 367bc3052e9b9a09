#include "SceneIsoSurface.h"

#include "DecimalText.h"
#include "FilterRun.h"
#include "IsoSurface.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr int Border = 1; // samples around the image, all below the value

// The image's samples with a border.
ScalarGrid GridOf(vtkImageData* image, double isoValue)
{
  ScalarGrid grid;
  const int* extent = image->GetExtent();
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grid.StartIndex[axis] = -Border;
    grid.StepIndex[axis] = 1.0;
    grid.Spacing[axis] = image->GetSpacing()[axis];
    grid.Size[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1 + 2 * Border;
    count *= static_cast<std::size_t>(grid.Size[axis]);
  }
  vtkDataArray* values = image->GetPointData()->GetScalars();
  double range[2];
  values->GetRange(range);
  // As far below the value as the darkest sample, so that the surface lies at most half-way to the
  // border.
  const double below = std::min(range[0], 2.0 * isoValue - range[1]);
  grid.Values.assign(count, static_cast<float>(below));
  vtkIdType id = 0;
  for (int k = Border; k < grid.Size[2] - Border; ++k)
  {
    for (int j = Border; j < grid.Size[1] - Border; ++j)
    {
      std::size_t place = static_cast<std::size_t>(k) * grid.SliceStride(2) +
                          static_cast<std::size_t>(j) * grid.SliceStride(1) + Border;
      for (int i = Border; i < grid.Size[0] - Border; ++i)
      {
        grid.Values[place++] = static_cast<float>(values->GetComponent(id++, 0));
      }
    }
  }
  return grid;
}

} // namespace

vtkSmartPointer<vtkPolyData> MakeIsoSurface(vtkImageData* image, double isoValue,
                                            const ProgressFunction& progress)
{
  const auto goOn = [&progress](double fraction) { ReportProgress(progress, fraction, "surface"); };
  goOn(0.0);
  ScalarGrid grid = GridOf(image, isoValue);
  goOn(0.3);
  vtkSmartPointer<vtkPolyData> surface =
      ExtractIsoSurface(grid, static_cast<float>(isoValue), SurfacePieces::All).Surface;
  goOn(0.9);
  if (surface->GetNumberOfCells() == 0)
  {
    double range[2] = {};
    image->GetScalarRange(range);
    throw FilterError("The iso-value " + SignificantText(isoValue) +
                      " gives no surface: the image's values run from " +
                      SignificantText(range[0]) + " to " + SignificantText(range[1]) + ".");
  }
  MoveToWorld(grid, image, surface);
  return surface;
}
} // namespace palpate
