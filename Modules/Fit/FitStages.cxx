#include "FitStages.h"

#include "AvailableMemory.h"
#include "FilterRun.h"
#include "FitHints.h"
#include "FitStructure.h"
#include "MaskSurface.h"
#include "RadialStages.h"
#include "SurfaceFit.h"
#include "SurfaceMapping.h"

#include <cmath>
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

// Whether a surface model may be chosen; not where a radial one is wanted whatever it loses.
bool MayTakeSurfaceModel(const FitSettings& settings)
{
  return settings.Model == FitSettings::ModelKind::Automatic &&
         settings.MaximumHiddenPercent < 100.0;
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
  SampleRadially(made, PartOf(progress, 0.4, 0.5));
  if (!IsHidden(result))
  {
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

// Whether a radial model is refused, misses the tolerance or has another volume.
bool IsDoubtful(const FitResult& radial)
{
  constexpr double LargestChange = 0.05; // of the volume
  const double change = radial.ModelMilliliters / radial.InputMilliliters() - 1.0;
  return radial.State == FitResult::Outcome::Refused ||
         (radial.State == FitResult::Outcome::Fitted &&
          (radial.Rms > radial.Settings.Tolerance.value_or(radial.Rms) ||
           std::abs(change) > LargestChange));
}

// A surface model takes the place of a doubtful radial one if it overlaps the structure more, or if
// both are refused and it has a way out.
bool IsBetter(const FitResult& surface, const FitResult& radial)
{
  const bool isFitted = surface.State == FitResult::Outcome::Fitted;
  if (radial.State == FitResult::Outcome::Fitted)
  {
    return isFitted && surface.Dice > radial.Dice;
  }
  return isFitted || (surface.State == FitResult::Outcome::Refused && !surface.OptionHint.empty());
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

void TrySurfaceModel(FitSamples made, FitResult& result, const ProgressFunction& progress)
{
  const double shared = SumOf(made.Found.Seconds);
  made.Found.Settings = result.Settings;
  RunStage(
      [&]
      {
        MapStructure(made, PartOf(progress, 0.0, 0.5));
        if (made.Found.Message.empty())
        {
          FitSurfaceModel(made.Boundary, made.Found, PartOf(progress, 0.5, 1.0));
        }
      },
      made.Found);
  if (IsBetter(made.Found, result))
  {
    std::swap(made.Found, result);
  }
  result.Seconds.emplace_back("rejected_model", SumOf(made.Found.Seconds) - shared);
}

void RunModel(const FitSamples& samples, FitResult& result, const ProgressFunction& progress)
{
  if (result.Details.Mapped != nullptr)
  {
    FitSurfaceModel(samples.Boundary, result, progress);
    return;
  }
  const bool isFinal = !MayTakeSurfaceModel(result.Settings);
  FitRadialModel(samples, result, PartOf(progress, 0.0, isFinal ? 1.0 : 0.5));
  if (!isFinal && IsDoubtful(result))
  {
    TrySurfaceModel(samples, result, PartOf(progress, 0.5, 1.0));
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
  RunStage([&] { MakeMaskSurface(made, progress); }, result);
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
    RunStage([&] { RunModel(samples, result, progress); }, result);
  }
  OfferTouch(result);
  return result;
}
} // namespace palpate
