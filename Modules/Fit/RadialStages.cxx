#include "RadialStages.h"

#include "DecimalText.h"
#include "DegreeGoal.h"
#include "FilterRun.h"
#include "FitQuality.h"
#include "FitVerdict.h"
#include "ModelOverlap.h"
#include "ModelPlausibility.h"
#include "ModelTable.h"
#include "OwnCopy.h"
#include "SphericalHarmonicMeasures.h"
#include "StageClock.h"
#include "StructureRemarks.h"
#include "Units.h"
#include "VoxelMinimum.h"
#include "vtkIcosahedronDirections.h"
#include "vtkRadialSampler.h"
#include "vtkSphericalHarmonicFit.h"
#include "vtkSphericalHarmonicSurface.h"

#include "vtkNew.h"
#include "vtkTable.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
void Configure(vtkRadialSampler* sampler, const FitSettings& settings)
{
  if (settings.GivenCenterWorld)
  {
    std::array<double, 3> center = *settings.GivenCenterWorld;
    sampler->SetCenterMode(vtkRadialSampler::GIVEN);
    sampler->SetCenter(center.data());
  }
  else if (settings.Center == FitSettings::CenterChoice::MostVisible)
  {
    sampler->SetCenterMode(vtkRadialSampler::MOST_VISIBLE);
  }
}

void Configure(vtkSphericalHarmonicFit* fit, const FitSettings& settings)
{
  fit->SetDegree(settings.Degree);
  fit->SetWeighting(static_cast<int>(settings.Weight));
  fit->SetMaximumDegree(settings.MaximumDegree);
  fit->SetPenalty(static_cast<int>(settings.PenaltyKind));
  fit->SetRoughness(settings.Roughness);
  fit->SetRobust(settings.IsRobust);
}

void TakeVerdict(vtkRadialSampler* sampler, FitResult& result)
{
  result.IsSampled = true;
  result.StarShaped = sampler->GetStarShaped();
  result.HiddenPercent = sampler->GetHiddenPercent();
  result.MultiplePercent = sampler->GetMultiplePercent();
  result.MissedPercent = sampler->GetMissedPercent();
}

void TakeFit(vtkSphericalHarmonicFit* fit, FitResult& result)
{
  SphericalHarmonicModel model;
  FromTable(fit->GetOutput(), model);
  result.ModelMilliliters = VolumeOf(model) / CubicMillimetersPerMilliliter;
  result.ModelAreaSquareMillimeters = AreaOf(model);
  result.Model = std::move(model);
  result.Condition = fit->GetCondition();
  result.Rms = fit->GetRms();
  result.NoiseDeviation = fit->GetNoiseDeviation();
  result.Roughness = fit->GetUsedRoughness();
  result.DegreesOfFreedom = fit->GetDegreesOfFreedom();
  result.DownWeighted = fit->GetDownWeighted();
  result.Coverage = fit->GetCoverage();
  for (int degree = 0; degree < fit->GetNumberOfDegrees(); ++degree)
  {
    result.RmsByDegree.push_back(fit->GetRmsOfDegree(degree));
  }
}
} // namespace

void SampleRadially(FitSamples& made, const ProgressFunction& progress)
{
  FitResult& result = made.Found;
  StageClock clock(result.Seconds);
  vtkNew<vtkIcosahedronDirections> directions;
  directions->SetFrequency(result.Settings.Frequency);
  vtkNew<vtkRadialSampler> sampler;
  sampler->SetInputData(0, OwnCopy(result.Surface.Get()));
  sampler->SetDirectionsConnection(directions->GetOutputPort());
  Configure(sampler, result.Settings);
  RunFilter(sampler, "samples", 0.0, 1.0, progress);
  made.Samples = sampler->GetOutput();
  TakeVerdict(sampler, result);
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

void FitRadialModel(const FitSamples& samples, FitResult& result, const ProgressFunction& progress)
{
  StageClock clock(result.Seconds);
  RemarkOnRest(result);
  const auto surface = OwnCopy(result.Surface.Get());
  vtkNew<vtkSphericalHarmonicFit> fit;
  fit->SetInputData(OwnCopy(samples.Samples.Get()));
  Configure(fit, result.Settings);
  fit->SetSupportedDegree(
      SupportedDegree(CubicMillimetersPerMilliliter * result.MaskMilliliters, result.Mask.Get()));
  if (const std::optional<DegreeGoal> goal = DegreeGoalOf(result))
  {
    fit->SetTolerance(goal->Tolerance);
    fit->SetLeastDegree(goal->Least);
    if (goal->IsOfVoxels) // a bound ends the search without an error
    {
      fit->SetSupportedDegree(std::min(fit->GetSupportedDegree(), result.Settings.MaximumDegree));
    }
  }
  try
  {
    RunFilter(fit, "fit", 0.0, 0.15, progress);
  }
  catch (const FilterError&)
  {
    result.OptionHint = OptionsOfFit(result.Settings);
    throw;
  }
  TakeFit(fit, result);
  RemarkOnDegree(fit->GetSupportedDegree(), result);
  RemarkOnCoverage(result);
  clock.EndStage("fit");
  vtkNew<vtkSphericalHarmonicSurface> model;
  model->SetInputConnection(fit->GetOutputPort());
  model->SetInputData(1, surface);
  model->SetFrequency(result.Settings.Frequency);
  RunFilter(model, "model", 0.15, 0.3, progress);
  result.ModelSurface = model->GetOutput();
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
