#include "OnDemandMemory.h"

#include "ImageWriter.h"
#include "ResidentMemory.h"
#include "SkullPhantom.h"
#include "TemporaryFolder.h"
#include "TouchRun.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkShortArray.h"

#include <malloc.h>

namespace palpate::bench
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

void WriteSkull(const std::filesystem::path& file)
{
  constexpr int Nodes = 512;
  SkullPhantom skull(Nodes);
  vtkNew<vtkShortArray> scalars;
  scalars->SetArray(skull.Samples.data(), static_cast<vtkIdType>(skull.Samples.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(skull.Grid.Size().data());
  image->SetSpacing(skull.Grid.Spacing().data());
  image->SetOrigin(skull.Grid.OriginWorld().data());
  image->GetPointData()->SetScalars(scalars);
  WriteImage(file, image);
}

TouchSettings SceneOf(const std::filesystem::path& file, FieldInterpolation interpolation,
                      std::optional<double> megabytes)
{
  TouchStructureSettings bone;
  bone.File = file;
  bone.Iso = SkullPhantom::BoneIso;
  bone.IsSeen = false;
  bone.Interpolation = interpolation;
  TouchSettings settings;
  settings.Structures = {bone};
  settings.Scale = 1.0;
  settings.MemoryMegabytes = megabytes;
  return settings;
}

OnDemandRow Measure(const std::filesystem::path& file, FieldInterpolation interpolation,
                    std::optional<double> megabytes, const std::filesystem::path& recording)
{
  OnDemandRow row{};
  row.Interpolation = interpolation;
  row.BudgetMegabytes = megabytes;
  TouchScript script;
  script.SweepSpeed = 90.0;
  script.Duration = 5.0;
  malloc_trim(0);
  const double before = ResidentMebibytes();
  const PreparedTouch touch = PrepareTouch(SceneOf(file, interpolation, megabytes), script, GoOn);
  malloc_trim(0);
  row.ResidentMebibytes = ResidentMebibytes() - before;
  row.Bytes = touch.Structures.front().Touch.Model->Bytes();
  row.MakeSeconds = touch.Structures.front().Seconds;
  TouchRunSettings run;
  run.Recording = megabytes ? std::filesystem::path() : recording;
  const auto& field = touch.Structures.front().OnDemand;
  const OnDemandCounts first = field != nullptr ? field->Counts() : OnDemandCounts();
  const TouchResult result = RunTouch(touch, run, GoOn);
  row.TickMicroseconds = 1e-3 * static_cast<double>(result.Durations.Median());
  row.CoarseTicks = result.CoarseTicks;
  if (field != nullptr)
  {
    row.Versions = field->Counts().Versions - first.Versions;
    row.Reads = field->Counts().BricksRead - first.BricksRead;
  }
  const TouchComparison comparison = CompareTouch(touch, recording);
  row.Ticks = comparison.Ticks;
  row.DifferentTicks = comparison.DifferentTicks;
  row.LargestDifference = comparison.LargestDifference;
  return row;
}
} // namespace

std::vector<OnDemandRow> MeasureOnDemand()
{
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "skull.nii";
  WriteSkull(file);
  std::vector<OnDemandRow> rows;
  for (const FieldInterpolation interpolation :
       {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    const bool isLinear = interpolation == FieldInterpolation::Trilinear;
    const auto recording = folder / "whole.touch";
    rows.push_back(Measure(file, interpolation, {}, recording));
    const double whole = 1e-6 * static_cast<double>(rows.back().Bytes);
    for (const double part : {0.5, isLinear ? 0.35 : 0.2})
    {
      rows.push_back(Measure(file, interpolation, part * whole, recording));
    }
  }
  return rows;
}
} // namespace palpate::bench
