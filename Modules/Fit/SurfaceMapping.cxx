#include "SurfaceMapping.h"

#include "DecimalText.h"
#include "FitVerdict.h"
#include "ImageIndexToWorld.h"
#include "KernelWatch.h"
#include "LabelMask.h"
#include "MappedSurface.h"
#include "MaskStage.h"
#include "MeshConversion.h"
#include "ModelSurface.h"
#include "RepairRemarks.h"
#include "StageClock.h"
#include "StructureChanges.h"
#include "StructureRemarks.h"
#include "SurfaceFileFit.h"
#include "SurfaceTopology.h"
#include "Units.h"

#include "vtkImageData.h"

#include <memory>
#include <utility>

namespace palpate
{
namespace
{
// Maps the structure, or the component of this number (0: all of it), and replaces its surface.
// Returns why it cannot, as a predicate, or an empty text; what it would change is in `changes`.
std::string MapToSphere(FitResult& result, int component, TopologyReport& changes,
                        const ProgressFunction& progress)
{
  if (result.IsOfSurface)
  {
    return MapSurfaceFile(result, progress);
  }
  KernelWatch watched(progress, "surface");
  auto mapped = std::make_shared<MappedSurface>();
  const Status status =
      MakeMappedSurface(CopyComponent(result.Mask, result.Structure.Value, component, 1),
                        IndexToWorldOf(result.Mask), {}, watched.Of(0.0, 1.0), *mapped);
  watched.Require();
  changes = mapped->Topology;
  if (!status.IsOk())
  {
    // Of a sponge, its holes are the reason.
    const Status changed = CheckTopology(changes, {});
    const bool isSponge = !changed.IsOk() && !result.Settings.Repairs;
    return isSponge ? changed.Message() : status.Message();
  }
  result.Surface = ToPolyData(mapped->Mesh);
  result.SurfaceMilliliters = DescribeTopology(mapped->Mesh).Volume / CubicMillimetersPerMilliliter;
  result.Details.Mapped = std::move(mapped);
  return {};
}

// What was changed to map a mask.
void RemarkOnRepair(FitResult& result)
{
  const MappedSurface& mapped = *result.Details.Mapped;
  RemarkOnChanges(mapped.Topology, result);
  if (!mapped.Lost.empty())
  {
    const LostPlace& farthest = mapped.Lost.front();
    result.Notes.push_back(
        "the surface leaves out thin parts at " +
        CountText(static_cast<std::int64_t>(mapped.Lost.size()), "place", "places") + ", up to " +
        FixedText(farthest.Distance, 1) + " mm at " + PlaceText(farthest.Farthest));
  }
}

// Whether a structure was mapped, within the limits of what may be changed.
bool IsMapped(FitResult& result, int component, const ProgressFunction& progress)
{
  TopologyReport changes;
  const std::string reason = MapToSphere(result, component, changes, progress);
  if (!reason.empty())
  {
    result.State = FitResult::Outcome::Refused; // by its shape, which no setting changes
    result.Message = reason;
    if (changes.Bridges.Count > 0 && !result.Settings.WantsOneComponent())
    {
      Refuse(reason, HintForEachPart, result); // its parts may have a better one
    }
    return false;
  }
  return AcceptChanges(result.Details.Mapped->Topology, result);
}
} // namespace

bool LeavesOutParts(const FitResult& result)
{
  const double all = AllParts(result);
  return 100.0 * (all - result.MaskMilliliters) > TopologyLimits().ChangedPercent * all;
}

bool MapWithItsParts(FitSamples& made, const ProgressFunction& progress)
{
  FitResult& result = made.Found;
  const std::vector<double>& parts = result.ComponentMilliliters;
  if (made.IsTriedWithParts || result.Settings.Component != 1 || result.Settings.IsAlone ||
      parts.size() < 2)
  {
    return false;
  }
  made.IsTriedWithParts = true;
  StageClock clock(result.Seconds);
  FitResult whole = result;
  const bool isMapped = IsMapped(whole, 0, PartOf(progress, 0.0, 0.8));
  const double all = AllParts(result);
  const double bestDice = 2.0 * parts.front() / (parts.front() + all);
  const bool isTooLittle = bestDice < result.Settings.MinimumDice ||
                           (result.Settings.Rules > 1 && LeavesOutParts(result));
  const bool isTaken = isMapped || isTooLittle;
  if (isTaken)
  {
    result = std::move(whole);
    result.MaskMilliliters = all;
  }
  if (isMapped)
  {
    RemarkOnRepair(result);
    made.Boundary = BoundaryOf(result, 0, PartOf(progress, 0.8, 1.0));
  }
  clock.EndStage("map");
  return isTaken;
}

void MapStructure(FitSamples& made, const ProgressFunction& progress)
{
  if (MapWithItsParts(made, PartOf(progress, 0.0, 0.5)))
  {
    return;
  }
  FitResult& result = made.Found;
  StageClock clock(result.Seconds);
  RemarkOnComponents(result);
  if (IsMapped(result, result.Settings.Component, PartOf(progress, 0.5, 1.0)) &&
      !result.IsOfSurface)
  {
    RemarkOnRepair(result);
  }
  clock.EndStage("map");
}
} // namespace palpate
