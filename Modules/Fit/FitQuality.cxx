#include "FitQuality.h"

#include "FilterRun.h"
#include "IsoSurface.h"
#include "MeshConversion.h"
#include "MeshDistances.h"

namespace palpate
{
namespace
{
void Report(double fraction, const ProgressFunction& progress)
{
  if (progress && !progress(fraction, "quality"))
  {
    throw Cancelled();
  }
}

ComparedSurface Prepared(vtkPolyData* surface)
{
  ComparedSurface prepared;
  if (const Status status = ComparedSurface::Make(ToIndexedMesh(surface), prepared); !status.IsOk())
  {
    throw FilterError(status.Message());
  }
  return prepared;
}

SurfaceDistances DistancesBetween(const ComparedSurface& one, const ComparedSurface& other)
{
  const DistanceSummary both = TwoSidedDistances(one.DistancesFrom(other), one.Weights(),
                                                 other.DistancesFrom(one), other.Weights());
  return {both.Mean, both.Rms, both.Percentile95, both.Largest};
}
} // namespace

void MeasureQuality(vtkPolyData* boundary, FitResult& result, const ProgressFunction& progress)
{
  Report(0.0, progress);
  const ComparedSurface model = Prepared(result.ModelSurface);
  const ComparedSurface surface = Prepared(result.Surface);
  result.SurfaceAreaSquareMillimeters = MeasureEnclosed(result.Surface).Area;
  Report(0.1, progress);
  result.ModelToSurface = DistancesBetween(model, surface);
  if (result.IsOfSurface)
  {
    Report(1.0, progress);
    return;
  }
  Report(0.3, progress);
  const ComparedSurface mask = Prepared(boundary);
  result.ModelToMask = DistancesBetween(model, mask);
  Report(0.7, progress);
  result.SurfaceToMask = DistancesBetween(surface, mask);
  Report(1.0, progress);
}
} // namespace palpate
