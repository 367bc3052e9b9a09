#include "MaskStage.h"

#include "FilterRun.h"
#include "FitHints.h"
#include "ImageIndexToWorld.h"
#include "KernelWatch.h"
#include "LabelMask.h"
#include "MaskSurface.h"
#include "MeshConversion.h"
#include "ScanBorder.h"
#include "StageClock.h"
#include "StructureRemarks.h"
#include "Units.h"
#include "VoxelMinimum.h"

#include <array>
#include <utility>

namespace palpate
{
namespace
{
LabelMask LabelVoxels(const FitResult& result)
{
  return CopyLabelMask(result.Mask, result.Structure.Value, 1);
}

// Of a structure's mask; throws FilterError.
MaskSurface SurfaceOf(const FitResult& result, LabelMask label, int component, bool isPlain,
                      const ProgressFunction& progress)
{
  KernelWatch watch(progress, "surface");
  const FitSettings& settings = result.Settings;
  MaskSurface surface;
  const Status status =
      MakeMaskSurface(std::move(label.Mask), IndexToWorldOf(result.Mask),
                      {isPlain, {settings.Smoothing, MaskSurfaceSettings::CellsOfModel}, component},
                      watch.Of(0.0, 1.0), surface);
  watch.Require();
  if (!status.IsOk())
  {
    throw FilterError(status.Message());
  }
  return surface;
}

double CutOf(const MaskSurface& surface, const FitResult& result)
{
  std::array<int, 3> size{};
  result.Mask->GetDimensions(size.data());
  return CutAreaOf(surface.Mesh, {LabelVoxels(result).Mask, IndexToWorldOf(result.Mask)}, size);
}

void TakeSurface(const MaskSurface& surface, FitResult& result)
{
  const auto milliliters = [](double volume) { return volume / CubicMillimetersPerMilliliter; };
  result.MaskMilliliters = milliliters(surface.MaskVolume);
  result.SurfaceMilliliters = milliliters(surface.SurfaceVolume);
  result.CavityCount = surface.FilledCavities.Count;
  result.CavityMilliliters = milliliters(surface.FilledCavities.Volume);
  result.LargestCavityMilliliters = milliliters(surface.FilledCavities.LargestVolume);
  for (const double volume : surface.ComponentVolumes)
  {
    result.ComponentMilliliters.push_back(milliliters(volume));
  }
  result.Surface = ToPolyData(surface.Mesh);
}
} // namespace

vtkSmartPointer<vtkPolyData> BoundaryOf(const FitResult& result, int component,
                                        const ProgressFunction& progress)
{
  return ToPolyData(SurfaceOf(result, LabelVoxels(result), component, true, progress).Mesh);
}

void RunMaskSurface(FitSurface& made, const ProgressFunction& progress)
{
  FitResult& result = made.Found;
  StageClock clock(result.Seconds);
  const bool isPlain = result.Settings.Method == FitSettings::SurfaceMethod::Plain;
  LabelMask label = LabelVoxels(result);
  result.TouchesBorder = label.TouchesBorder();
  const MaskSurface surface = SurfaceOf(result, std::move(label), result.Settings.Component,
                                        isPlain, PartOf(progress, 0.0, 0.8));
  TakeSurface(surface, result);
  result.CutArea = result.TouchesBorder ? CutOf(surface, result) : 0.0;
  clock.EndStage("surface");
  result.Message = TooFewVoxels(surface.MaskVolume, result.Mask);
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
