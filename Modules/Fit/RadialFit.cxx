#include "RadialFit.h"

#include "DecimalText.h"
#include "DegreeGoal.h"
#include "DegreeSearch.h"
#include "FilterRun.h"
#include "FitQuality.h"
#include "FitVerdict.h"
#include "KernelWatch.h"
#include "MeshConversion.h"
#include "ModelMeasures.h"
#include "ModelOverlap.h"
#include "ModelPlausibility.h"
#include "RadialModelFit.h"
#include "RadialModelSurface.h"
#include "StageClock.h"
#include "StructureRemarks.h"
#include "Units.h"
#include "VoxelMinimum.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace palpate
{
namespace
{
Vector3 CenterOf(const IndexedMesh& mesh, const FitSettings& settings)
{
  if (settings.GivenCenterWorld)
  {
    return Vector3(settings.GivenCenterWorld->data());
  }
  return settings.Center == FitSettings::CenterChoice::MostVisible ? MostVisibleCenter(mesh)
                                                                   : VolumeCentroid(mesh);
}

RadialModelFitOptions OptionsOf(const FitSettings& settings)
{
  RadialModelFitOptions options;
  options.Degree = settings.Degree;
  options.PenaltyKind = static_cast<RadialModelFitOptions::Penalty>(settings.PenaltyKind);
  options.Roughness = settings.Roughness;
  options.RobustKind = settings.IsRobust ? RadialModelFitOptions::Robust::Huber
                                         : RadialModelFitOptions::Robust::None;
  return options;
}

void TakeFit(const RadialModelFitResult& fit, int degree, const Vector3& center, FitResult& result)
{
  RadialModel model(degree, fit.Coefficients, center);
  result.ModelMilliliters = VolumeOf(model) / CubicMillimetersPerMilliliter;
  result.ModelAreaSquareMillimeters = AreaOf(model);
  result.Model = std::move(model);
  result.Condition = fit.Condition;
  result.Rms = fit.Rms;
  result.NoiseDeviation = fit.NoiseDeviation;
  result.Roughness = fit.Roughness;
  result.DegreesOfFreedom = fit.DegreesOfFreedom;
  result.DownWeighted = static_cast<int>(fit.DownWeighted);
  result.RmsByDegree = fit.RmsByDegree;
}

// Of the degree asked for, or that meets the goal. Throws FilterError and Cancelled.
RadialModelFitResult FitSamplesTo(const RadialSampling& sampling,
                                  const std::optional<DegreeGoal>& goal, int supported,
                                  FitResult& result, const ProgressFunction& progress)
{
  KernelWatch watch(progress, "fit");
  const KernelProgress goOn = watch.Of(0.0, 1.0);
  const auto weight = static_cast<RadialWeight>(result.Settings.Weight);
  const RadialSamples samples = SamplesOf(sampling, weight);
  RadialModelFitOptions options = OptionsOf(result.Settings);
  options.IsCancelled = [&goOn] { return !goOn(0.1); };
  Status status = Status::Success();
  if (goal)
  {
    const DegreeSearch search{goal->Tolerance, goal->Least, result.Settings.MaximumDegree,
                              supported};
    status = FindDegree(samples, options, search, options.Degree);
  }
  RadialModelFitResult fit;
  if (status.IsOk())
  {
    status = FitRadialModel(samples, options, fit);
  }
  if (status.IsOk())
  {
    status = AssessCoverage(samples.Directions, samples.Weights, fit, result.Coverage);
  }
  watch.Require();
  if (!status.IsOk())
  {
    result.OptionHint = OptionsOfFit(result.Settings);
    throw FilterError(status.Message());
  }
  TakeFit(fit, options.Degree, sampling.CenterWorld, result);
  return fit;
}
} // namespace

void RunSampling(FitSamples& made, const ProgressFunction& progress)
{
  FitResult& result = made.Found;
  StageClock clock(result.Seconds);
  KernelWatch watch(progress, "samples");
  const KernelProgress goOn = watch.Of(0.0, 1.0);
  const IndexedMesh mesh = ToIndexedMesh(result.Surface);
  const Vector3 center = CenterOf(mesh, result.Settings);
  auto sampling = std::make_shared<const RadialSampling>(
      SampleRadially(mesh, center, result.Settings.Frequency, goOn));
  watch.Require();
  result.IsSampled = true;
  result.StarShaped = sampling->Seen.IsStarShaped;
  result.HiddenPercent = sampling->Seen.HiddenPercent;
  result.MultiplePercent = sampling->MultiplePercent;
  result.MissedPercent = sampling->MissedPercent;
  made.Samples = std::move(sampling);
  clock.EndStage("samples");
}

bool IsHidden(const FitResult& result)
{
  return result.HiddenPercent > result.Settings.MaximumHiddenPercent;
}

void RefuseHidden(FitResult& result)
{
  RemarkOnRest(result);
  const double limit = result.Settings.MaximumHiddenPercent;
  Refuse("is not star-shaped: the centre does not see " +
             TextAgainstLimit(result.HiddenPercent, limit, 1) + " % of its surface (limit " +
             TextAgainstLimit(limit, limit, 1) +
             " %), so one radius per direction cannot describe it",
         HintForHidden, result);
}

void MakeRadialFit(const FitSamples& samples, FitResult& result, const ProgressFunction& progress)
{
  StageClock clock(result.Seconds);
  RemarkOnRest(result);
  const std::optional<DegreeGoal> goal = DegreeGoalOf(result);
  int supported =
      SupportedDegree(CubicMillimetersPerMilliliter * result.MaskMilliliters, result.Mask.Get());
  if (goal && goal->IsOfVoxels) // a bound ends the search without an error
  {
    supported = std::min(supported, result.Settings.MaximumDegree);
  }
  const RadialModelFitResult fit =
      FitSamplesTo(*samples.Samples, goal, supported, result, PartOf(progress, 0.0, 0.15));
  RemarkOnDegree(supported, result);
  RemarkOnCoverage(result);
  clock.EndStage("fit");
  const Eigen::MatrixXd factor = fit.Covariance.Factor();
  const IndexedMesh surface = ToIndexedMesh(result.Surface);
  result.ModelSurface =
      DrawRadialModel(*result.Radial(), result.Settings.Frequency, {&factor, &surface});
  ReportProgress(progress, 0.3, "model");
  clock.EndStage("model");
  if (const std::string reason = WhyImplausible(result); !reason.empty())
  {
    Refuse(reason, HintForImplausible, result);
    result.ModelSurface = nullptr; // nothing to show: it reaches far beyond the image
    return;
  }
  if (const std::string remark = RemarkOnNegativeRadius(result); !remark.empty())
  {
    result.Notes.push_back(remark);
  }
  MeasureOverlap(result);
  MeasureQuality(samples.Boundary, result, PartOf(progress, 0.3, 1.0));
  clock.EndStage("quality");
  JudgeOverlap(result);
}
} // namespace palpate
