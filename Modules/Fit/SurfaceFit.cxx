#include "SurfaceFit.h"

#include "ClosestPointDistances.h"
#include "DecimalText.h"
#include "DegreeBracket.h"
#include "DegreeGoal.h"
#include "FitDeviation.h"
#include "FitQuality.h"
#include "FitVerdict.h"
#include "IcosahedronDirections.h"
#include "KernelWatch.h"
#include "MeshConversion.h"
#include "MeshCrossings.h"
#include "ModelMeasures.h"
#include "ModelOverlap.h"
#include "ModelSurface.h"
#include "StageClock.h"
#include "SurfaceModelUncertainty.h"
#include "Units.h"
#include "VoxelMinimum.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// Crossings of the drawn surface, and whether it overlaps itself too much (CheckRegularity).
Status JudgeDrawn(FitResult& result)
{
  const WindingOverlap overlap = MeasureOverlap(result);
  result.Details.IrregularPercent = overlap.IrregularPercent();
  MeshCrossings crossings;
  if (FindMeshCrossings(ToIndexedMesh(result.ModelSurface), {}, crossings).IsOk())
  {
    result.Details.Crossings = crossings.Count;
  }
  return CheckRegularity(overlap);
}

// The degree asked for, or the smallest that meets the tolerance.
Status FitDegree(const FitResult& found, int supported, SurfaceModelFitResult& fit,
                 KernelWatch& watched)
{
  const MappedSurface& mapped = *found.Details.Mapped;
  const FitSettings& settings = found.Settings;
  SurfaceModelFitOptions options;
  options.Placing = found.IsOriented ? SurfaceModelFitOptions::PlacementKind::Frame
                                     : SurfaceModelFitOptions::PlacementKind::Ellipsoid;
  const auto fitTo = [&](int degree, double from, double to, SurfaceModelFitResult& result)
  {
    options.Degree = degree;
    return FitSurfaceModel(mapped.Mesh, mapped.Directions, options, result, watched.Of(from, to));
  };
  const std::optional<DegreeGoal> goal = DegreeGoalOf(found);
  const int least = goal ? std::max(goal->Least, 1) : 0;
  const int highest = std::min(std::max(supported, least), settings.MaximumDegree);
  if (!goal || highest < 1) // the fit says what is wrong with degree 0
  {
    return fitTo(goal ? highest : settings.Degree, 0.0, 1.0, fit);
  }
  DegreeBracket bracket(goal->Tolerance, least, highest);
  const double unlimited = options.LargestRms;
  Status status = Status::Success();
  double begin = 0.0;
  for (std::optional<int> degree = bracket.Next(); status.IsOk() && degree; degree = bracket.Next())
  {
    const double end = (1.0 + begin) / 2.0;
    options.LargestRms = *degree < highest ? goal->Tolerance : unlimited;
    SurfaceModelFitResult tried;
    status = fitTo(*degree, begin, end, tried);
    begin = end;
    if (status.IsOk() && bracket.Add(*degree, tried.NormalRms))
    {
      fit = std::move(tried);
    }
  }
  return status;
}

// Trust in the fit, and the drawn model.
Status JudgeFit(const IndexedMesh& mesh, const SurfaceModelFitResult& fit, FitResult& result)
{
  SurfaceModelUncertainty uncertainty;
  Status status = AssessSurfaceModelFit(mesh, fit, uncertainty);
  if (!status.IsOk())
  {
    return status;
  }
  result.Condition = uncertainty.Condition;
  result.NoiseDeviation = uncertainty.NoiseDeviation;
  result.DegreesOfFreedom = uncertainty.DegreesOfFreedom;
  result.Coverage = uncertainty.Coverage;
  const int frequency = DrawnFrequency(result.Model, result.Settings.Frequency);
  result.ModelSurface = DrawModel(result.Model, frequency);
  result.ModelSurface->GetPointData()->AddArray(
      FitDeviation(uncertainty.Covariance.Factor(), IcosahedronDirections(frequency).Directions(),
                   "NormalDeviation"));
  return status;
}

void RemarkOnPlacement(bool isAmbiguous, FitResult& result)
{
  if (!result.IsOriented)
  {
    result.Notes.push_back(
        std::string("the file states no axes in the patient, so the parameters follow the axes of "
                    "the ellipsoid of degree 1") +
        (isAmbiguous ? ", two of which are within 10 % and may turn: parameters do not correspond "
                       "to those of other cases"
                     : ", whose signs may change from case to case"));
  }
}

void RemarkOnFit(FitResult& result)
{
  const SurfaceModelDetails& details = result.Details;
  if (details.Crossings > 0)
  {
    result.Notes.push_back(
        "the model crosses itself at " + CountText(details.Crossings, "pair", "pairs") +
        " of the drawn triangles (" + SignificantText(details.IrregularPercent, 2) +
        " % of the mask's voxels lie outside in it or inside twice)");
  }
  RemarkOnCoverage(result);
}

// Fits a model and draws it. Returns why it cannot, as a predicate, or an empty text.
std::string FitAndDraw(FitResult& result, const ProgressFunction& progress)
{
  KernelWatch watched(progress, "fit");
  const MappedSurface& mapped = *result.Details.Mapped;
  const int supported =
      SupportedDegree(CubicMillimetersPerMilliliter * result.MaskMilliliters, result.Mask);
  SurfaceModelFitResult fit;
  const Status status = FitDegree(result, supported, fit, watched);
  watched.Require();
  if (!status.IsOk())
  {
    return status.Message();
  }
  const std::optional<DegreeGoal> goal = DegreeGoalOf(result);
  const double tolerance = goal && !goal->IsOfVoxels ? goal->Tolerance : fit.NormalRms;
  if (fit.NormalRms > tolerance && fit.Surface.Degree() < supported)
  {
    const std::string highest = std::to_string(fit.Surface.Degree());
    return "needs more than degree " + highest + " to meet the tolerance of " +
           TextAgainstLimit(tolerance, tolerance, 3) + " mm; degree " + highest + " leaves " +
           TextAgainstLimit(fit.NormalRms, tolerance, 3) + " mm";
  }
  result.Rms = fit.NormalRms;
  result.Details.Determination = fit.Placement.Determination;
  result.Details.Folded = fit.Folded;
  result.ModelMilliliters = fit.Surface.Volume() / CubicMillimetersPerMilliliter;
  result.ModelAreaSquareMillimeters = fit.Surface.Area();
  result.Model = fit.Surface;
  if (const Status judged = JudgeFit(mapped.Mesh, fit, result); !judged.IsOk())
  {
    return judged.Message();
  }
  const Status regular = JudgeDrawn(result);
  RemarkOnPlacement(fit.IsAmbiguous, result);
  RemarkOnFit(result);
  return regular.Message();
}

// Signed distances of the drawn model's points from the surface that was fitted.
void AddDistances(vtkPolyData* surface, vtkPolyData* drawn)
{
  const std::vector<double> found =
      SignedDistances(ToIndexedMesh(drawn).Points, ToIndexedMesh(surface));
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("DistanceToSurface");
  distances->SetNumberOfValues(drawn->GetNumberOfPoints());
  std::copy(found.begin(), found.end(), distances->GetPointer(0));
  drawn->GetPointData()->AddArray(distances);
}
} // namespace

void MakeSurfaceFit(vtkPolyData* boundary, FitResult& result, const ProgressFunction& progress)
{
  StageClock clock(result.Seconds);
  const std::string reason = FitAndDraw(result, PartOf(progress, 0.0, 0.7));
  clock.EndStage("fit");
  if (!reason.empty())
  {
    Refuse(reason, HintForDegree, result);
    return;
  }
  RemarkOnDegree(DegreeOf(result.Model), result);
  AddDistances(result.Surface, result.ModelSurface);
  MeasureQuality(boundary, result, PartOf(progress, 0.7, 1.0));
  clock.EndStage("quality");
  JudgeOverlap(result);
}
} // namespace palpate
