#include "FitStructure.h"

#include "FilterRun.h"
#include "ModelTable.h"
#include "StageClock.h"
#include "VoxelMinimum.h"
#include "vtkIcosahedronDirections.h"
#include "vtkRadialSampler.h"
#include "vtkSegmentationSurface.h"
#include "vtkSphericalHarmonicFit.h"
#include "vtkSphericalHarmonicSurface.h"
#include "vtkSurfaceQuality.h"

#include "vtkNew.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace palpate
{
namespace
{
constexpr double CubicMillimetersPerMilliliter = 1000.0;
struct Pipeline
{
  vtkNew<vtkSegmentationSurface> Surface;
  vtkNew<vtkSegmentationSurface> Boundary; // the mask's own half level, to measure against
  vtkNew<vtkIcosahedronDirections> Directions;
  vtkNew<vtkRadialSampler> Sampler;
  vtkNew<vtkSphericalHarmonicFit> Fit;
  vtkNew<vtkSphericalHarmonicSurface> Model;
};

void Configure(Pipeline& pipeline, vtkImageData* layer, int value, const FitSettings& settings)
{
  for (vtkSegmentationSurface* surface : {pipeline.Surface.Get(), pipeline.Boundary.Get()})
  {
    surface->SetInputData(layer);
    surface->SetLabel(value);
    surface->SetComponent(settings.Component);
    surface->SetSmoothing(settings.Smoothing);
  }
  pipeline.Boundary->SetMethodToPlain();
  if (settings.Method == FitSettings::SurfaceMethod::Plain)
  {
    pipeline.Surface->SetMethodToPlain();
  }
  pipeline.Directions->SetFrequency(settings.Frequency);

  vtkRadialSampler* sampler = pipeline.Sampler;
  sampler->SetInputConnection(0, pipeline.Surface->GetOutputPort());
  sampler->SetDirectionsConnection(pipeline.Directions->GetOutputPort());
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

  vtkSphericalHarmonicFit* fit = pipeline.Fit;
  fit->SetInputConnection(sampler->GetOutputPort());
  fit->SetDegree(settings.Degree);
  fit->SetWeighting(static_cast<int>(settings.Weight));
  fit->SetTolerance(settings.Tolerance.value_or(0.0));
  fit->SetMaximumDegree(settings.MaximumDegree);
  fit->SetPenalty(static_cast<int>(settings.PenaltyKind));
  fit->SetRoughness(settings.Roughness);

  pipeline.Model->SetInputConnection(fit->GetOutputPort());
  pipeline.Model->SetOriginalConnection(pipeline.Surface->GetOutputPort());
  pipeline.Model->SetFrequency(settings.Frequency);
}

SurfaceDistances DistancesOf(vtkSurfaceQuality* quality)
{
  return {quality->GetMeanDistance(), quality->GetRmsDistance(), quality->GetPercentile95Distance(),
          quality->GetMaximumDistance()};
}

void TakeSurface(const Pipeline& pipeline, FitResult& result)
{
  vtkSegmentationSurface* surface = pipeline.Surface;
  result.MaskMilliliters = surface->GetMaskVolume() / CubicMillimetersPerMilliliter;
  result.SurfaceMilliliters = surface->GetSurfaceVolume() / CubicMillimetersPerMilliliter;
  result.TouchesBorder = surface->GetTouchesBorder();
  result.CavityCount = surface->GetCavityCount();
  result.CavityMilliliters = surface->GetCavityVolume() / CubicMillimetersPerMilliliter;
  for (int rank = 0; rank < surface->GetNumberOfComponents(); ++rank)
  {
    result.ComponentMilliliters.push_back(surface->GetComponentVolume(rank) /
                                          CubicMillimetersPerMilliliter);
  }
  result.Surface = surface->GetOutput();
}

std::string Fixed(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string Counted(long count, const char* one, const char* several)
{
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

// What a reader of the result should know about the structure.
void RemarkOnStructure(const Pipeline& pipeline, FitResult& result)
{
  if (result.TouchesBorder)
  {
    result.Notes.push_back("the structure touches the border of its volume and is closed there; "
                           "the true surface may go on");
  }
  if (result.ComponentMilliliters.size() > 1 && result.Settings.Component > 0)
  {
    result.Notes.push_back("the label has " + std::to_string(result.ComponentMilliliters.size()) +
                           " connected components; number " +
                           std::to_string(result.Settings.Component) + " (" +
                           Fixed(result.MaskMilliliters, 2) + " ml) was taken");
  }
  if (result.CavityCount > 0)
  {
    result.Notes.push_back(Counted(result.CavityCount, "cavity", "cavities") + " of " +
                           Fixed(result.CavityMilliliters, 3) + " ml in all filled");
  }
  if (pipeline.Surface->GetUsedDistanceInstead())
  {
    result.Notes.push_back("slices overlap too little to interpolate the shape between them; the "
                           "distance in space was used");
  }
}

void TakeVerdict(vtkRadialSampler* sampler, FitResult& result)
{
  result.StarShaped = sampler->GetStarShaped();
  result.HiddenPercent = sampler->GetHiddenPercent();
  result.MultiplePercent = sampler->GetMultiplePercent();
  result.MissedPercent = sampler->GetMissedPercent();
}

void TakeFit(const Pipeline& pipeline, FitResult& result)
{
  vtkSphericalHarmonicFit* fit = pipeline.Fit;
  FromTable(fit->GetOutput(), result.Model);
  result.Condition = fit->GetCondition();
  result.Rms = fit->GetRms();
  result.NoiseDeviation = fit->GetNoiseDeviation();
  result.Roughness = fit->GetUsedRoughness();
  result.DegreesOfFreedom = fit->GetDegreesOfFreedom();
  for (int degree = 0; degree < fit->GetNumberOfDegrees(); ++degree)
  {
    result.RmsByDegree.push_back(fit->GetRmsOfDegree(degree));
  }
  result.ModelMilliliters = result.Model.Volume() / CubicMillimetersPerMilliliter;
  result.ModelAreaSquareMillimeters = result.Model.Area();
}

void MeasureQuality(const Pipeline& pipeline, const Segment& structure, FitResult& result,
                    const ProgressFunction& progress)
{
  vtkNew<vtkSurfaceQuality> quality;
  quality->SetInputData(0, result.ModelSurface);
  quality->SetReferenceData(result.Surface);
  RunFilter(quality, "quality", 0.6, 0.75, progress);
  result.ModelToSurface = DistancesOf(quality);
  result.SurfaceAreaSquareMillimeters = quality->GetArea() - quality->GetAreaDifference();

  quality->SetReferenceData(pipeline.Boundary->GetOutput());
  quality->SetMaskData(result.Mask);
  quality->SetLabel(structure.Value);
  RunFilter(quality, "quality", 0.75, 0.9, progress);
  result.ModelToMask = DistancesOf(quality);
  result.Dice = quality->GetDice();

  quality->SetInputData(0, result.Surface);
  quality->SetMaskData(nullptr);
  RunFilter(quality, "quality", 0.9, 1.0, progress);
  result.SurfaceToMask = DistancesOf(quality);
}

// Runs every stage; returns early with State and Message set where the structure stands in the way.
void RunStages(Pipeline& pipeline, const Segment& structure, FitResult& result,
               const ProgressFunction& progress)
{
  StageClock clock(result.Seconds);
  RunFilter(pipeline.Surface, "surface", 0.0, 0.25, progress);
  TakeSurface(pipeline, result);
  RemarkOnStructure(pipeline, result);
  clock.EndStage("surface");
  result.Message = TooFewVoxels(pipeline.Surface->GetMaskVolume(), result.Mask);
  if (!result.Message.empty())
  {
    result.State = FitResult::Outcome::BadInput;
    return;
  }
  RunFilter(pipeline.Boundary, "surface", 0.25, 0.3, progress);
  clock.EndStage("boundary");

  RunFilter(pipeline.Sampler, "samples", 0.3, 0.4, progress);
  TakeVerdict(pipeline.Sampler, result);
  clock.EndStage("samples");
  if (result.HiddenPercent > result.Settings.MaximumHiddenPercent)
  {
    result.State = FitResult::Outcome::Refused;
    result.Message = "is not star-shaped: the centre does not see " +
                     Fixed(result.HiddenPercent, 1) + " % of its surface (limit " +
                     Fixed(result.Settings.MaximumHiddenPercent, 1) +
                     " %), so one radius a direction cannot describe it; try the most visible "
                     "centre, or raise the limit to see what is lost";
    return;
  }
  RunFilter(pipeline.Fit, "fit", 0.4, 0.5, progress);
  TakeFit(pipeline, result);
  clock.EndStage("fit");
  RunFilter(pipeline.Model, "model", 0.5, 0.6, progress);
  result.ModelSurface = pipeline.Model->GetOutput();
  clock.EndStage("model");
  MeasureQuality(pipeline, structure, result, progress);
  clock.EndStage("quality");
  if (result.Dice < result.Settings.MinimumDice)
  {
    result.State = FitResult::Outcome::Refused;
    result.Message = "is not followed by a model of degree " +
                     std::to_string(result.Model.Degree()) + ": Dice " + Fixed(result.Dice, 2) +
                     ", " + Fixed(result.ModelMilliliters, 2) + " ml for a mask of " +
                     Fixed(result.MaskMilliliters, 2) +
                     " ml; try another degree, more directions or the most visible centre, or "
                     "lower the limit on Dice to see it";
    return;
  }
  result.State = FitResult::Outcome::Fitted;
}
} // namespace

FitResult FitStructure(const Segmentation& segmentation, const Segment& structure,
                       const FitSettings& settings, const ProgressFunction& progress)
{
  FitResult result;
  result.Input = segmentation.Source;
  result.CaseName = CaseNameOf(segmentation.Source);
  result.Structure = structure;
  result.Settings = settings;
  result.Notes = segmentation.Notes;
  result.Mask = segmentation.Layers[static_cast<std::size_t>(structure.Layer)];
  Pipeline pipeline;
  Configure(pipeline, result.Mask, structure.Value, settings);
  try
  {
    RunStages(pipeline, structure, result, progress);
  }
  catch (const FilterError& error)
  {
    result.State = FitResult::Outcome::Failed;
    result.Message = error.what();
  }
  return result;
}

std::string CaseNameOf(const std::filesystem::path& file)
{
  std::string name = file.filename().string();
  for (const char* ending : {".gz", ".nii", ".nrrd", ".seg", ".nhdr", ".mha", ".mhd", ".dcm"})
  {
    const std::string text = ending;
    if (name.size() > text.size() &&
        name.compare(name.size() - text.size(), text.size(), text) == 0)
    {
      name.erase(name.size() - text.size());
    }
  }
  return name;
}
} // namespace palpate
