#include "FitStages.h"

#include "AvailableMemory.h"
#include "DegreeGoal.h"
#include "FilterRun.h"
#include "FitHints.h"
#include "FitStructure.h"
#include "MaskStage.h"
#include "ModelChoice.h"
#include "RadialFit.h"
#include "StructureChanges.h"
#include "StructureRemarks.h"
#include "SurfaceFit.h"
#include "SurfaceMapping.h"

#include <cmath>
#include <new>
#include <utility>

namespace palpate
{
namespace
{
// Runs a stage and stores its failures in the result.
template <typename Stage>
void RunStage(const Stage& stage, FitResult& result)
{
  try
  {
    stage();
  }
  catch (const FilterError& error)
  {
    result.State = FitResult::Outcome::Failed;
    result.Message = error.what();
  }
  catch (const std::exception& error)
  {
    if (!SaysMemoryIsShort(error))
    {
      throw;
    }
    // Fails only this structure: others may be smaller.
    result.State = FitResult::Outcome::Failed;
    result.Message = "needs more memory than is available";
    result.OptionHint = "try a smaller image or a lower --degree or --frequency";
    result.WindowHint = "try a smaller image, a lower degree or a lower Frequency";
  }
}

// What no setting helps can still be felt.
void OfferTouch(FitResult& result)
{
  if (result.State == FitResult::Outcome::Refused && result.OptionHint.empty())
  {
    result.OptionHint = HintForShape();
  }
}

// Whether a radial model may change the structure as much as it does. One that is wanted whatever
// it loses may.
bool IsAcceptedRadially(FitResult& result)
{
  return result.Settings.Rules < 2 || result.Settings.AcceptsAllHidden() ||
         AcceptChanges(ChangesOf(result), result);
}

void RunSamples(FitSamples& made, const ProgressFunction& progress)
{
  FitResult& result = made.Found;
  if (result.Settings.Model == FitSettings::ModelKind::Surface)
  {
    MapStructure(made, progress);
    return;
  }
  if (MayTakeSurfaceModel(result.Settings) && LeavesOutParts(result) &&
      MapWithItsParts(made, PartOf(progress, 0.0, 0.4)))
  {
    return;
  }
  RunSampling(made, PartOf(progress, 0.4, 0.5));
  if (!IsHidden(result))
  {
    if (!IsAcceptedRadially(result))
    {
      RemarkOnRest(result);
    }
    return;
  }
  if (MayTakeSurfaceModel(result.Settings))
  {
    MapStructure(made, PartOf(progress, 0.5, 1.0));
  }
  else
  {
    RefuseHidden(result);
  }
}

double SumOf(const std::vector<std::pair<std::string, double>>& seconds)
{
  double sum = 0.0;
  for (const auto& stage : seconds)
  {
    sum += stage.second;
  }
  return sum;
}

// Returns which model was taken, and why.
std::string TrySurfaceModel(FitSamples made, FitResult& result, const ProgressFunction& progress)
{
  const double shared = SumOf(made.Found.Seconds);
  made.Found.Settings = result.Settings;
  RunStage(
      [&]
      {
        MapStructure(made, PartOf(progress, 0.0, 0.5));
        if (made.Found.Message.empty())
        {
          MakeSurfaceFit(made.Boundary, made.Found, PartOf(progress, 0.5, 1.0));
        }
      },
      made.Found);
  std::string reason = ReasonOfChoice(made.Found, result);
  if (IsBetter(made.Found, result))
  {
    std::swap(made.Found, result);
  }
  result.Seconds.emplace_back("rejected_model", SumOf(made.Found.Seconds) - shared);
  return reason;
}

// The model of the kind that is asked for or better, and which that was and why.
std::string RunModel(const FitSamples& samples, FitResult& result, const ProgressFunction& progress)
{
  std::string reason;
  if (result.Details.Mapped != nullptr)
  {
    MakeSurfaceFit(samples.Boundary, result, progress);
    return reason;
  }
  const bool isFinal = !MayTakeSurfaceModel(result.Settings);
  MakeRadialFit(samples, result, PartOf(progress, 0.0, isFinal ? 1.0 : 0.5));
  if (!isFinal && IsDoubtful(result))
  {
    reason = TrySurfaceModel(samples, result, PartOf(progress, 0.5, 1.0));
  }
  ReportProgress(progress, 1.0, "quality");
  return reason;
}

// The model of the kind that was taken, by the smallest degree that meets the goal. It takes the
// place of `result` unless it is worse.
void SearchDegree(FitSamples made, FitResult& result, const ProgressFunction& progress)
{
  FitResult& found = made.Found;
  const double shared = SumOf(found.Seconds);
  found.Settings = result.Settings;
  RunStage(
      [&]
      {
        const bool isSurface = result.Details.Mapped != nullptr;
        if (isSurface && found.Details.Mapped == nullptr)
        {
          MapStructure(made, PartOf(progress, 0.0, 0.3));
        }
        if (!found.Message.empty())
        {
          return;
        }
        isSurface ? MakeSurfaceFit(made.Boundary, found, PartOf(progress, 0.3, 1.0))
                  : MakeRadialFit(made, found, PartOf(progress, 0.3, 1.0));
      },
      found);
  if (found.State == FitResult::Outcome::Fitted && found.Dice >= result.Dice &&
      found.ModelToInput().Percentile95 <= result.ModelToInput().Percentile95)
  {
    std::swap(found, result);
  }
  result.Seconds.emplace_back("rejected_degree", SumOf(found.Seconds) - shared);
}

// A degree by the voxels is never worse than the given one, with which the kind is chosen.
void RunModelAndSearch(const FitSamples& samples, FitResult& result,
                       const ProgressFunction& progress)
{
  const FitSettings settings = result.Settings;
  const std::optional<DegreeGoal> goal = DegreeGoalOf(result);
  const bool isOfVoxels = goal && goal->IsOfVoxels;
  if (isOfVoxels)
  {
    result.Settings.Tolerance.reset();
    result.Settings.Degree = goal->Least;
  }
  const std::string reason =
      RunModel(samples, result, PartOf(progress, 0.0, isOfVoxels ? 0.5 : 1.0));
  result.Settings = settings;
  if (isOfVoxels && result.State == FitResult::Outcome::Fitted && MissesGoal(result))
  {
    SearchDegree(samples, result, PartOf(progress, 0.5, 1.0));
  }
  if (!reason.empty())
  {
    result.Notes.push_back(reason);
  }
  ReportProgress(progress, 1.0, "quality");
}
} // namespace

FitSurface MakeFitSurface(const Segmentation& segmentation, const Segment& structure,
                          const FitSettings& settings, const ProgressFunction& progress)
{
  FitSurface made;
  FitResult& result = made.Found;
  result.Input = segmentation.Source;
  result.CaseName = CaseNameOf(segmentation.Source);
  result.Structure = structure;
  result.Settings = settings;
  result.Notes = segmentation.Notes;
  result.Mask = segmentation.Layers[static_cast<std::size_t>(structure.Layer)];
  result.IsOriented = segmentation.IsOriented;
  RunStage([&] { RunMaskSurface(made, progress); }, result);
  made.IsOver = !result.Message.empty();
  return made;
}

FitSamples MakeFitSamples(const FitSurface& surface, const FitSettings& settings,
                          const ProgressFunction& progress)
{
  FitSamples made{surface.Found, surface.Boundary, nullptr, surface.IsOver};
  made.Found.Settings = settings;
  if (!made.IsOver)
  {
    RunStage([&] { RunSamples(made, progress); }, made.Found);
    made.IsOver = !made.Found.Message.empty();
  }
  return made;
}

FitResult MakeFitModel(const FitSamples& samples, const FitSettings& settings,
                       const ProgressFunction& progress)
{
  FitResult result = samples.Found;
  result.Settings = settings;
  if (!samples.IsOver)
  {
    RunStage([&] { RunModelAndSearch(samples, result, progress); }, result);
  }
  RemarkOnGoal(result);
  RemarkOnAcceptance(result);
  OfferTouch(result);
  return result;
}
} // namespace palpate
