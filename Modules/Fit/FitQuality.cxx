#include "FitQuality.h"

#include "FilterRun.h"
#include "MeshConversion.h"
#include "MeshDistances.h"
#include "SurfaceTopology.h"

namespace palpate
{
namespace
{
constexpr const char* QualityStage = "quality";

ComparedSurface Prepared(const IndexedMesh& mesh)
{
  ComparedSurface prepared;
  if (const Status status = ComparedSurface::Make(mesh, prepared); !status.IsOk())
  {
    throw FilterError(status.Message());
  }
  return prepared;
}

SurfaceDistances DistancesBetween(const ComparedSurface& one, const ComparedSurface& other)
{
  const DistanceSummary both = TwoSidedDistances(one.SamplesFrom(other), other.SamplesFrom(one));
  return {both.Mean, both.Rms, both.Percentile95, both.Largest};
}
} // namespace

void MeasureQuality(vtkPolyData* boundary, FitResult& result, const ProgressFunction& progress)
{
  ReportProgress(progress, 0.0, QualityStage);
  const IndexedMesh mesh = ToIndexedMesh(result.Surface);
  const ComparedSurface model = Prepared(ToIndexedMesh(result.ModelSurface));
  const ComparedSurface surface = Prepared(mesh);
  result.SurfaceAreaSquareMillimeters = MeasureEnclosed(mesh).Area;
  ReportProgress(progress, 0.1, QualityStage);
  result.ModelToSurface = DistancesBetween(model, surface);
  if (result.IsOfSurface)
  {
    ReportProgress(progress, 1.0, QualityStage);
    return;
  }
  ReportProgress(progress, 0.3, QualityStage);
  const ComparedSurface mask = Prepared(ToIndexedMesh(boundary));
  result.ModelToMask = DistancesBetween(model, mask);
  ReportProgress(progress, 0.7, QualityStage);
  result.SurfaceToMask = DistancesBetween(surface, mask);
  ReportProgress(progress, 1.0, QualityStage);
}
} // namespace palpate
