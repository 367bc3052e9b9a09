#include "SceneIsoSurface.h"

#include "DecimalText.h"
#include "FilterRun.h"
#include "ImageIndexToWorld.h"
#include "MappedSurface.h"
#include "MarchingCubes.h"
#include "MeshConversion.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>

namespace palpate
{
namespace
{
SampledGrid GridOf(vtkImageData* image, double isoValue)
{
  SampledGrid grid;
  image->GetDimensions(grid.Size.data());
  vtkDataArray* values = image->GetPointData()->GetScalars();
  double range[2];
  values->GetRange(range);
  // As far below the value as the darkest sample, so that the surface lies at most half-way to the
  // border.
  grid.Beyond = static_cast<float>(std::min(range[0], 2.0 * isoValue - range[1]));
  grid.Row = [values, size = grid.Size](int j, int k, float* row)
  {
    vtkIdType id = (static_cast<vtkIdType>(k) * size[1] + j) * size[0];
    for (int i = 0; i < size[0]; ++i)
    {
      row[i] = static_cast<float>(values->GetComponent(id++, 0));
    }
  };
  return grid;
}
} // namespace

vtkSmartPointer<vtkPolyData> MakeIsoSurface(vtkImageData* image, double isoValue,
                                            const ProgressFunction& progress)
{
  const auto goOn = [&progress](double fraction) { ReportProgress(progress, fraction, "surface"); };
  goOn(0.0);
  IndexedMesh mesh;
  if (!MarchCubes(GridOf(image, isoValue), static_cast<float>(isoValue), mesh))
  {
    throw FilterError("The surface would have too many points.");
  }
  goOn(0.9);
  if (mesh.Triangles.empty())
  {
    double range[2] = {};
    image->GetScalarRange(range);
    throw FilterError("The iso-value " + SignificantText(isoValue) +
                      " gives no surface: the image's values run from " +
                      SignificantText(range[0]) + " to " + SignificantText(range[1]) + ".");
  }
  MoveToWorld(IndexToWorldOf(image), mesh);
  return ToPolyData(mesh);
}
} // namespace palpate
