#include "SurfaceFit.h"

#include "DecimalText.h"
#include "KernelWatch.h"
#include "LabelMask.h"
#include "MaskComponents.h"
#include "MeshCrossings.h"
#include "ModelSurface.h"
#include "ParametricFit.h"
#include "ParametricSurfaceMeasures.h"
#include "ReferenceVoxels.h"
#include "RepairRemarks.h"
#include "SurfaceFileFit.h"
#include "TriangleMesh.h"
#include "VoxelMinimum.h"
#include "WindingNumbers.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr double CubicMillimetersPerMilliliter = 1000.0;

VoxelMask MaskOf(const FitResult& result, int rim)
{
  VoxelMask mask = CopyLabelMask(result.Mask, result.Structure.Value, rim).Mask;
  if (result.Settings.Component > 0)
  {
    MaskComponents(mask).Keep(result.Settings.Component - 1, mask);
  }
  return mask;
}

vtkSmartPointer<vtkPolyData> PolyDataOf(const IndexedMesh& mesh)
{
  TriangleMesh drawn;
  drawn.PointsWorld = mesh.Points;
  drawn.Triangles = mesh.Triangles;
  return PolyDataOf(drawn);
}

void RemarkOnRepair(const MappedSurface& mapped, FitResult& result)
{
  RemarkOnChanges(mapped.Topology, result);
  if (!mapped.Lost.empty())
  {
    const LostPlace& farthest = mapped.Lost.front();
    result.Notes.push_back("the surface leaves out thin parts at " +
                           std::to_string(mapped.Lost.size()) + " places, up to " +
                           FixedText(farthest.Distance, 1) + " mm at " +
                           PlaceText(farthest.Farthest));
  }
}

// Overlap with what was fitted, and crossings of the drawn surface.
void MeasureDrawn(const IndexedMesh& drawn, FitResult& result)
{
  const ReferenceVoxels reference = ReferenceVoxelsOf(result);
  std::vector<std::int16_t> numbers;
  if (FindWindingNumbers(drawn, reference.Centers, numbers).IsOk())
  {
    result.Details.IrregularPercent =
        CompareWithMask(numbers, reference.Inside.data()).IrregularPercent();
  }
  MeshCrossings crossings;
  if (FindMeshCrossings(drawn, {}, crossings).IsOk())
  {
    result.Details.Crossings = crossings.Count;
  }
}

// The degree asked for, or the smallest that meets the tolerance.
Status FitDegree(const MappedSurface& mapped, const FitSettings& settings, int supported,
                 ParametricFitResult& fit, KernelWatch& watched)
{
  ParametricFitOptions options;
  if (!settings.Tolerance)
  {
    options.Degree = settings.Degree;
    return FitParametricSurface(mapped.Mesh, mapped.Directions, options, fit, watched.Of(0.0, 1.0));
  }
  const int highest = std::clamp(supported, 1, settings.MaximumDegree);
  Status status = Status::Success();
  for (int degree = 1; status.IsOk(); degree = std::min(degree + std::max(1, degree / 4), highest))
  {
    options.Degree = degree;
    const double done = static_cast<double>(degree) / (highest + 1.0);
    status =
        FitParametricSurface(mapped.Mesh, mapped.Directions, options, fit, watched.Of(done, done));
    if (fit.NormalRms <= *settings.Tolerance || degree == highest)
    {
      break;
    }
  }
  return status;
}
} // namespace

std::string MapToParameterSphere(FitResult& result, const ProgressFunction& progress)
{
  if (result.IsOfSurface)
  {
    return MapSurfaceFile(result, progress);
  }
  KernelWatch watched(progress, "surface");
  MappedSurfaceSettings settings;
  settings.IgnoresLimits = result.Settings.Repairs;
  settings.Surface.Topology.BridgeParts = result.Settings.Repairs;
  auto mapped = std::make_shared<MappedSurface>();
  const Status status = MakeMappedSurface(MaskOf(result, 1), WorldOf(result.Mask), settings,
                                          watched.Of(0.0, 1.0), *mapped);
  watched.Require();
  if (!status.IsOk())
  {
    return status.Message();
  }
  RemarkOnRepair(*mapped, result);
  result.Surface = PolyDataOf(mapped->Mesh);
  result.Details.Mapped = std::move(mapped);
  return {};
}

std::string FitSurfaceModel(FitResult& result, const ProgressFunction& progress)
{
  KernelWatch watched(progress, "fit");
  const MappedSurface& mapped = *result.Details.Mapped;
  const int supported =
      SupportedDegree(CubicMillimetersPerMilliliter * result.MaskMilliliters, result.Mask);
  ParametricFitResult fit;
  const Status status = FitDegree(mapped, result.Settings, supported, fit, watched);
  watched.Require();
  if (!status.IsOk())
  {
    return status.Message();
  }
  result.Rms = fit.NormalRms;
  result.Details.Determination = fit.Placement.Determination;
  result.Details.Folded = fit.Folded;
  result.ModelMilliliters = fit.Surface.Volume() / CubicMillimetersPerMilliliter;
  result.ModelAreaSquareMillimeters = fit.Surface.Area();
  result.Model = fit.Surface;
  result.ModelSurface = DrawModel(result.Model, result.Settings.Frequency);
  const TriangleMesh drawn = TrianglesOf(result.ModelSurface, "model");
  MeasureDrawn({drawn.PointsWorld, drawn.Triangles}, result);
  return {};
}
} // namespace palpate
