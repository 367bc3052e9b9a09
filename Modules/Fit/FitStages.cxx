#include "FitStages.h"

#include "ClosestPointDistances.h"
#include "DecimalText.h"
#include "FilterRun.h"
#include "FitHints.h"
#include "FitQuality.h"
#include "FitStructure.h"
#include "MeshConversion.h"
#include "ModelOverlap.h"
#include "ModelPlausibility.h"
#include "ModelTable.h"
#include "SphericalHarmonicMeasures.h"
#include "StageClock.h"
#include "StructureRemarks.h"
#include "SurfaceFileFit.h"
#include "SurfaceFit.h"
#include "Units.h"
#include "VoxelMinimum.h"
#include "vtkIcosahedronDirections.h"
#include "vtkRadialSampler.h"
#include "vtkSegmentationSurface.h"
#include "vtkSphericalHarmonicFit.h"
#include "vtkSphericalHarmonicSurface.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace palpate
{
namespace
{
// Cells on the surface that is fitted: far finer than the details of a model, and enough for Dice
// above 0.999 with the mask. More would only take time.
constexpr int CellsOnSurface = 12000;

// A pipeline modifies its input's information, which other threads may be reading.
template <typename Data>
vtkSmartPointer<Data> OwnCopy(Data* shared)
{
  auto copy = vtkSmartPointer<Data>::New();
  copy->ShallowCopy(shared);
  return copy;
}

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
  catch (const std::bad_alloc&)
  {
    // Fails only this structure: others may be smaller.
    result.State = FitResult::Outcome::Failed;
    result.Message = "needs more memory than is available";
    result.OptionHint = "try a smaller image or a lower --degree or --frequency";
    result.WindowHint = "try a smaller image, a lower degree or a lower Frequency";
  }
}

void Refuse(const std::string& reason, Hint& hint, FitResult& result)
{
  result.State = FitResult::Outcome::Refused;
  result.Message = reason;
  FitSettings settings = result.Settings;
  if (result.Details.Mapped != nullptr)
  {
    settings.Model = FitSettings::ModelKind::Surface;
  }
  result.OptionHint = hint(settings, OptionWords);
  result.WindowHint = hint(settings, WindowWords);
}

void Configure(vtkSegmentationSurface* surface, vtkImageData* layer, int value,
               const FitSettings& settings)
{
  surface->SetInputData(layer);
  surface->SetLabel(value);
  surface->SetComponent(settings.Component);
  surface->SetSmoothing(settings.Smoothing);
  surface->SetCellsOnSurface(CellsOnSurface);
}

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
  fit->SetTolerance(settings.Tolerance.value_or(0.0));
  fit->SetMaximumDegree(settings.MaximumDegree);
  fit->SetPenalty(static_cast<int>(settings.PenaltyKind));
  fit->SetRoughness(settings.Roughness);
  fit->SetRobust(settings.IsRobust);
}

void TakeSurface(vtkSegmentationSurface* surface, FitResult& result)
{
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

// If the degree search ended before it met the tolerance.
void RemarkOnDegree(int supported, FitResult& result)
{
  const double tolerance = result.Settings.Tolerance.value_or(result.Rms);
  if (result.Rms > tolerance)
  {
    result.Notes.push_back(
        "degree " + std::to_string(supported) +
        " is the highest that the mask's voxels support (wavelengths of two voxels); it leaves " +
        TextAgainstLimit(result.Rms, tolerance, 3) + " mm instead of the " +
        TextAgainstLimit(tolerance, tolerance, 3) + " mm requested");
  }
}

// If too few directions determine part of the model.
void RemarkOnCoverage(FitResult& result)
{
  if (result.Coverage.Outcome != DirectionCoverage::Verdict::Good)
  {
    result.Notes.push_back(result.Coverage.Message);
  }
}

// Accepts a model that overlaps the mask enough.
void JudgeOverlap(FitResult& result)
{
  const double limit = result.Settings.MinimumDice;
  if (!(result.Dice >= limit))
  {
    Refuse("is not matched by a model of degree " + std::to_string(DegreeOf(result.Model)) +
               ": Dice " + TextAgainstLimit(result.Dice, limit, 2) + " (limit " +
               TextAgainstLimit(limit, limit, 2) + "), " + FixedText(result.ModelMilliliters, 2) +
               " ml for a " + (result.IsOfSurface ? "surface" : "mask") + " of " +
               FixedText(result.InputMilliliters(), 2) + " ml",
           HintForMisfit, result);
    return;
  }
  result.State = FitResult::Outcome::Fitted;
}

// The half-level surface of a component of the mask.
vtkSmartPointer<vtkPolyData> BoundaryOf(const FitResult& result, int component,
                                        const ProgressFunction& progress)
{
  FitSettings settings = result.Settings;
  settings.Component = component;
  vtkNew<vtkSegmentationSurface> boundary;
  Configure(boundary, OwnCopy(result.Mask.Get()), result.Structure.Value, settings);
  boundary->SetMethodToPlain();
  RunFilter(boundary, "surface", 0.8, 1.0, progress);
  return boundary->GetOutput();
}

void RunSurface(FitSurface& made, const ProgressFunction& progress)
{
  FitResult& result = made.Found;
  StageClock clock(result.Seconds);
  const auto layer = OwnCopy(result.Mask.Get());
  vtkNew<vtkSegmentationSurface> surface;
  Configure(surface, layer, result.Structure.Value, result.Settings);
  if (result.Settings.Method == FitSettings::SurfaceMethod::Plain)
  {
    surface->SetMethodToPlain();
  }
  RunFilter(surface, "surface", 0.0, 0.8, progress);
  TakeSurface(surface, result);
  clock.EndStage("surface");
  result.Message = TooFewVoxels(surface->GetMaskVolume(), result.Mask);
  if (!result.Message.empty())
  {
    result.State = FitResult::Outcome::BadInput;
    result.OptionHint = HintForTooFewVoxels();
    result.WindowHint = ChooseAnother;
    return;
  }
  // Only for a structure that is modelled: for one that is too small, the message is enough.
  RemarkOnStructure(result);
  made.Boundary = BoundaryOf(result, result.Settings.Component, progress);
  clock.EndStage("boundary");
}

// Whether a structure was mapped, within the limits of what may be changed.
bool IsMapped(FitResult& result, int component, const ProgressFunction& progress)
{
  const std::string reason = MapToParameterSphere(result, component, progress);
  if (!reason.empty())
  {
    result.State = FitResult::Outcome::Refused; // by its shape, which no setting changes
    result.Message = reason;
    return false;
  }
  const Status changed = CheckTopology(result.Details.Mapped->Topology, {});
  if (!changed.IsOk() && !result.Settings.Repairs)
  {
    Refuse(changed.Message(), HintForRepair, result);
    return false;
  }
  return true;
}

// A surface model of the largest component also takes in parts that are near it, as masks of thin
// structures often have: voxels that touch by an edge, or slices that do not overlap. Parts that
// are too far are the reason of a refusal if the largest alone cannot match the mask.
bool IsMappedWithItsParts(FitSamples& made, const ProgressFunction& progress)
{
  FitResult& result = made.Found;
  const std::vector<double>& parts = result.ComponentMilliliters;
  if (result.Settings.Component != 1 || result.Settings.IsAlone || parts.size() < 2)
  {
    return false;
  }
  FitResult whole = result;
  const bool isMapped = IsMapped(whole, 0, progress);
  const double all = AllParts(result);
  const double bestDice = 2.0 * parts.front() / (parts.front() + all);
  if (!isMapped && bestDice >= result.Settings.MinimumDice)
  {
    return false;
  }
  result = std::move(whole);
  result.MaskMilliliters = all;
  if (!isMapped)
  {
    return false;
  }
  made.Boundary = BoundaryOf(result, 0, progress);
  return true;
}

// The structure's place on the parameter sphere.
void RunMap(FitSamples& made, const ProgressFunction& progress)
{
  FitResult& result = made.Found;
  StageClock clock(result.Seconds);
  const bool hasParts = IsMappedWithItsParts(made, progress);
  const bool isRefused = !result.Message.empty();
  if (!hasParts && !isRefused)
  {
    RemarkOnComponents(result);
  }
  if (hasParts || (!isRefused && IsMapped(result, result.Settings.Component, progress)))
  {
    if (!result.IsOfSurface)
    {
      RemarkOnRepair(result);
    }
  }
  clock.EndStage("map");
}

// Of a structure in parts, a radial model describes the largest; a surface model takes in those
// that are near it. Returns whether it does, or whether they are the reason of a refusal.
bool IsMappedForItsParts(FitSamples& made, const ProgressFunction& progress)
{
  FitResult& result = made.Found;
  const double left = AllParts(result) - result.MaskMilliliters;
  if (result.Settings.Model != FitSettings::ModelKind::Automatic ||
      result.Settings.MaximumHiddenPercent >= 100.0 ||
      !(100.0 * left > TopologyLimits().ChangedPercent * AllParts(result)))
  {
    return false;
  }
  StageClock clock(result.Seconds);
  const bool hasParts = IsMappedWithItsParts(made, progress);
  if (hasParts)
  {
    RemarkOnRepair(result);
  }
  clock.EndStage("map");
  return hasParts || !result.Message.empty();
}

void RunSamples(FitSamples& made, const ProgressFunction& progress)
{
  FitResult& result = made.Found;
  if (result.Settings.Model == FitSettings::ModelKind::Surface)
  {
    RunMap(made, progress);
    return;
  }
  if (IsMappedForItsParts(made, progress))
  {
    return;
  }
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
  const bool isHidden = result.HiddenPercent > result.Settings.MaximumHiddenPercent;
  if (isHidden && result.Settings.Model == FitSettings::ModelKind::Automatic)
  {
    RunMap(made, progress);
    return;
  }
  if (isHidden)
  {
    RemarkOnRest(result);
    const double limit = result.Settings.MaximumHiddenPercent;
    Refuse("is not star-shaped: the centre does not see " +
               TextAgainstLimit(result.HiddenPercent, limit, 1) + " % of its surface (limit " +
               TextAgainstLimit(limit, limit, 1) +
               " %), so one radius per direction cannot describe it",
           HintForHidden, result);
  }
}

void RunModel(vtkPolyData* samples, vtkPolyData* boundary, FitResult& result,
              const ProgressFunction& progress)
{
  StageClock clock(result.Seconds);
  RemarkOnRest(result);
  const auto surface = OwnCopy(result.Surface.Get());
  vtkNew<vtkSphericalHarmonicFit> fit;
  fit->SetInputData(OwnCopy(samples));
  Configure(fit, result.Settings);
  fit->SetSupportedDegree(
      SupportedDegree(CubicMillimetersPerMilliliter * result.MaskMilliliters, result.Mask.Get()));
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
  MeasureQuality(boundary, result, progress);
  clock.EndStage("quality");
  JudgeOverlap(result);
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

void RunSurfaceModel(vtkPolyData* boundary, FitResult& result, const ProgressFunction& progress)
{
  StageClock clock(result.Seconds);
  const std::string reason = FitSurfaceModel(result, progress);
  clock.EndStage("fit");
  if (!reason.empty())
  {
    Refuse(reason, HintForDegree, result);
    return;
  }
  RemarkOnDegree(DegreeOf(result.Model), result);
  AddDistances(result.Surface, result.ModelSurface);
  MeasureQuality(boundary, result, progress);
  clock.EndStage("quality");
  JudgeOverlap(result);
}

// Whether a radial model is refused, misses the tolerance or has another volume, and is not wanted
// whatever it loses.
bool IsDoubtful(const FitResult& radial)
{
  constexpr double LargestChange = 0.05; // of the volume
  if (radial.Settings.Model != FitSettings::ModelKind::Automatic ||
      radial.Settings.MaximumHiddenPercent >= 100.0)
  {
    return false;
  }
  const double change = radial.ModelMilliliters / radial.InputMilliliters() - 1.0;
  return radial.State == FitResult::Outcome::Refused ||
         (radial.State == FitResult::Outcome::Fitted &&
          (radial.Rms > radial.Settings.Tolerance.value_or(radial.Rms) ||
           std::abs(change) > LargestChange));
}

// A surface model takes the place of a doubtful radial one if it overlaps the structure more, or if
// both are refused and it has a way out.
void TrySurfaceModel(FitSamples made, FitResult& radial, const ProgressFunction& progress)
{
  made.Found.Settings = radial.Settings;
  double tried = 0.0;
  for (std::size_t stage = made.Found.Seconds.size(); stage < radial.Seconds.size(); ++stage)
  {
    tried += radial.Seconds[stage].second;
  }
  made.Found.Seconds.emplace_back("radial", tried);
  RunStage(
      [&]
      {
        RunMap(made, progress);
        if (made.Found.Message.empty())
        {
          RunSurfaceModel(made.Boundary, made.Found, progress);
        }
      },
      made.Found);
  const FitResult::Outcome found = made.Found.State;
  const bool isBetter = radial.State == FitResult::Outcome::Refused
                            ? found == FitResult::Outcome::Fitted || !made.Found.OptionHint.empty()
                            : found == FitResult::Outcome::Fitted && made.Found.Dice > radial.Dice;
  if (isBetter)
  {
    radial = std::move(made.Found);
  }
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
  RunStage([&] { RunSurface(made, progress); }, result);
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
    RunStage(
        [&]
        {
          if (result.Details.Mapped != nullptr)
          {
            RunSurfaceModel(samples.Boundary, result, progress);
          }
          else
          {
            RunModel(samples.Samples, samples.Boundary, result, progress);
            if (IsDoubtful(result))
            {
              TrySurfaceModel(samples, result, progress);
            }
          }
        },
        result);
  }
  return result;
}
} // namespace palpate
