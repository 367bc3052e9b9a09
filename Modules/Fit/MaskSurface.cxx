#include "MaskSurface.h"

#include "FilterRun.h"
#include "FitHints.h"
#include "OwnCopy.h"
#include "StageClock.h"
#include "StructureRemarks.h"
#include "Units.h"
#include "VoxelMinimum.h"
#include "vtkSegmentationSurface.h"

#include "vtkNew.h"

namespace palpate
{
namespace
{
// Cells on the surface that is fitted: far finer than the details of a model, and enough for Dice
// above 0.999 with the mask. More would only take time.
constexpr int CellsOnSurface = 12000;

void Configure(vtkSegmentationSurface* surface, vtkImageData* layer, int value,
               const FitSettings& settings)
{
  surface->SetInputData(layer);
  surface->SetLabel(value);
  surface->SetComponent(settings.Component);
  surface->SetSmoothing(settings.Smoothing);
  surface->SetCellsOnSurface(CellsOnSurface);
}

void TakeSurface(vtkSegmentationSurface* surface, FitResult& result)
{
  result.MaskMilliliters = surface->GetMaskVolume() / CubicMillimetersPerMilliliter;
  result.SurfaceMilliliters = surface->GetSurfaceVolume() / CubicMillimetersPerMilliliter;
  result.TouchesBorder = surface->GetTouchesBorder();
  result.CavityCount = surface->GetCavityCount();
  result.CavityMilliliters = surface->GetCavityVolume() / CubicMillimetersPerMilliliter;
  result.LargestCavityMilliliters =
      surface->GetLargestCavityVolume() / CubicMillimetersPerMilliliter;
  for (int rank = 0; rank < surface->GetNumberOfComponents(); ++rank)
  {
    result.ComponentMilliliters.push_back(surface->GetComponentVolume(rank) /
                                          CubicMillimetersPerMilliliter);
  }
  result.Surface = surface->GetOutput();
}
} // namespace

vtkSmartPointer<vtkPolyData> BoundaryOf(const FitResult& result, int component,
                                        const ProgressFunction& progress)
{
  FitSettings settings = result.Settings;
  settings.Component = component;
  vtkNew<vtkSegmentationSurface> boundary;
  Configure(boundary, OwnCopy(result.Mask.Get()), result.Structure.Value, settings);
  boundary->SetMethodToPlain();
  RunFilter(boundary, "surface", 0.0, 1.0, progress);
  return boundary->GetOutput();
}

void MakeMaskSurface(FitSurface& made, const ProgressFunction& progress)
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
  made.Boundary = BoundaryOf(result, result.Settings.Component, PartOf(progress, 0.8, 1.0));
  clock.EndStage("boundary");
}
} // namespace palpate
