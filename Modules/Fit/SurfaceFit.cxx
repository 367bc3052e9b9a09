#include "SurfaceFit.h"

#include "DecimalText.h"
#include "FilterRun.h"
#include "FitDeviation.h"
#include "FitQuality.h"
#include "IcosahedronDirections.h"
#include "LabelMask.h"
#include "MaskComponents.h"
#include "MeshConversion.h"
#include "MeshCrossings.h"
#include "ModelSurface.h"
#include "ParametricSurfaceMeasures.h"
#include "ParametricUncertainty.h"
#include "TriangleMesh.h"
#include "VoxelMinimum.h"

#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr double CubicMillimetersPerMilliliter = 1000.0;

// Lets a kernel's cancellation through as Cancelled.
class Watched
{
public:
  Watched(const ProgressFunction& progress, std::string stage)
      : Progress(progress), Stage(std::move(stage))
  {
  }

  KernelProgress Of(double from, double to)
  {
    return [this, from, to](double part)
    {
      this->IsCancelled = this->Progress && !this->Progress(from + (to - from) * part, this->Stage);
      return !this->IsCancelled;
    };
  }
  void Require() const
  {
    if (this->IsCancelled)
    {
      throw Cancelled();
    }
  }

private:
  const ProgressFunction& Progress;
  std::string Stage;
  bool IsCancelled = false;
};

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

std::string PlaceText(const Vector3& placeWorld)
{
  return "(" + FixedText(placeWorld.x(), 1) + ", " + FixedText(placeWorld.y(), 1) + ", " +
         FixedText(placeWorld.z(), 1) + ")";
}

void RemarkOnChange(const TopologyChange& change, const char* one, const char* several,
                    FitResult& result)
{
  if (change.Count > 0)
  {
    result.Notes.push_back(
        std::to_string(change.Count) + " " + (change.Count == 1 ? one : several) + ", " +
        SignificantText(change.Volume, 3) + " mm\xC2\xB3; the largest of " +
        FixedText(change.LargestExtent, 1) + " mm at " + PlaceText(change.LargestCentre));
  }
}

void RemarkOnRepair(const MappedSurface& mapped, FitResult& result)
{
  const TopologyReport& report = mapped.Topology;
  RemarkOnChange(report.DroppedParts, "small part dropped", "small parts dropped", result);
  RemarkOnChange(report.Bridges, "part joined by a bridge", "parts joined by bridges", result);
  RemarkOnChange(report.FilledCavities, "cavity filled", "cavities filled", result);
  RemarkOnChange(report.CutHandles, "handle cut", "handles cut", result);
  RemarkOnChange(report.FilledHandles, "handle filled", "handles filled", result);
  if (!mapped.Lost.empty())
  {
    const LostPlace& farthest = mapped.Lost.front();
    result.Notes.push_back("the surface leaves out thin parts at " +
                           std::to_string(mapped.Lost.size()) + " places, up to " +
                           FixedText(farthest.Distance, 1) + " mm at " +
                           PlaceText(farthest.Farthest));
  }
}

// The degree asked for, or the smallest that meets the tolerance: first upwards by quarters, then
// by bisection.
Status FitDegree(const MappedSurface& mapped, const FitSettings& settings, int supported,
                 ParametricFitResult& fit, Watched& watched)
{
  ParametricFitOptions options;
  const auto fitTo = [&](int degree, double from, double to, ParametricFitResult& result)
  {
    options.Degree = degree;
    return FitParametricSurface(mapped.Mesh, mapped.Directions, options, result,
                                watched.Of(from, to));
  };
  if (!settings.Tolerance)
  {
    return fitTo(settings.Degree, 0.0, 1.0, fit);
  }
  const int highest = std::clamp(supported, 1, settings.MaximumDegree);
  const auto partOf = [highest](int degree) { return static_cast<double>(degree) / highest; };
  int below = 0;
  int degree = 1;
  Status status = fitTo(degree, 0.0, partOf(degree), fit);
  while (status.IsOk() && fit.NormalRms > *settings.Tolerance && degree < highest)
  {
    below = degree;
    degree = std::min(degree + std::max(1, degree / 4), highest);
    status = fitTo(degree, partOf(below), partOf(degree), fit);
  }
  while (status.IsOk() && fit.NormalRms <= *settings.Tolerance && degree - below > 1)
  {
    const int between = (below + degree) / 2;
    ParametricFitResult smaller;
    status = fitTo(between, partOf(degree), partOf(degree), smaller);
    const bool meets = smaller.NormalRms <= *settings.Tolerance;
    (meets ? degree : below) = between;
    if (meets)
    {
      fit = std::move(smaller);
    }
  }
  return status;
}

// Trust in the fit, and the drawn model.
Status JudgeFit(const IndexedMesh& mesh, const ParametricFitResult& fit, FitResult& result)
{
  ParametricUncertainty uncertainty;
  const Status status = AssessParametricFit(mesh, fit, uncertainty);
  if (!status.IsOk())
  {
    return status;
  }
  result.Condition = uncertainty.Condition;
  result.NoiseDeviation = uncertainty.NoiseDeviation;
  result.DegreesOfFreedom = uncertainty.DegreesOfFreedom;
  result.Coverage = uncertainty.Coverage;
  result.ModelSurface = DrawModel(result.Model, result.Settings.Frequency);
  const CovarianceFactor::PlainObject factor = uncertainty.Covariance.Factor();
  result.ModelSurface->GetPointData()->AddArray(FitDeviation(
      CovarianceFactor(factor.data(), factor.rows(), factor.cols()),
      IcosahedronDirections(result.Settings.Frequency).Directions(), "NormalDeviation"));
  return status;
}

void RemarkOnFit(FitResult& result)
{
  const SurfaceModelDetails& details = result.Details;
  if (details.Crossings > 0)
  {
    result.Notes.push_back("the model crosses itself at " + std::to_string(details.Crossings) +
                           (details.Crossings == 1 ? " pair" : " pairs") +
                           " of the drawn triangles (" +
                           SignificantText(details.IrregularPercent, 2) +
                           " % of the mask's voxels lie outside in it or inside twice)");
  }
  if (result.Coverage.Outcome != DirectionCoverage::Verdict::Good)
  {
    result.Notes.push_back(result.Coverage.Message);
  }
}
} // namespace

std::string MapToParameterSphere(FitResult& result, const ProgressFunction& progress)
{
  Watched watched(progress, "surface");
  MappedSurfaceSettings settings;
  settings.IgnoresLimits = result.Settings.Repairs;
  settings.Surface.Topology.BridgeParts = result.Settings.Repairs;
  auto mapped = std::make_shared<MappedSurface>();
  const Status status = MakeMappedSurface(MaskOf(result, 1), IndexToWorldOf(result.Mask), settings,
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
  Watched watched(progress, "fit");
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
  if (const Status judged = JudgeFit(mapped.Mesh, fit, result); !judged.IsOk())
  {
    return judged.Message();
  }
  MeasureOverlap(result);
  MeshCrossings crossings;
  if (FindMeshCrossings(ToIndexedMesh(result.ModelSurface), {}, crossings).IsOk())
  {
    result.Details.Crossings = crossings.Count;
  }
  RemarkOnFit(result);
  return {};
}
} // namespace palpate
