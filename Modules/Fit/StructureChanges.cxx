#include "StructureChanges.h"

#include "DecimalText.h"
#include "FitVerdict.h"
#include "StructureRemarks.h"
#include "Units.h"
#include "WindingNumbers.h"

namespace palpate
{
namespace
{
constexpr double NearLimit = 0.9; // of it

// Components that are not in the model. One that was asked for by its number is all there is.
TopologyChange PartsLeftOut(const FitResult& result)
{
  TopologyChange parts;
  const double left = AllParts(result) - result.MaskMilliliters;
  constexpr double Rounding = 1e-9;
  if (!result.Settings.WantsOneComponent() && left > Rounding * result.MaskMilliliters)
  {
    parts.Count = static_cast<int>(result.ComponentMilliliters.size()) - 1;
    parts.Volume = CubicMillimetersPerMilliliter * left;
    parts.LargestVolume = CubicMillimetersPerMilliliter * result.ComponentMilliliters[1];
  }
  return parts;
}

TopologyReport CavitiesOf(const FitResult& result)
{
  TopologyReport report;
  report.ObjectVolume = CubicMillimetersPerMilliliter * result.MaskMilliliters;
  report.FilledCavities.Count = result.CavityCount;
  report.FilledCavities.Volume = CubicMillimetersPerMilliliter * result.CavityMilliliters;
  report.FilledCavities.LargestVolume =
      CubicMillimetersPerMilliliter * result.LargestCavityMilliliters;
  return report;
}

void RemarkNear(const std::string& amount, FitResult& result)
{
  result.Notes.push_back("accepted near a limit: " + amount +
                         "; a mask of another grid may be refused");
}

void RemarkNear(const std::string& what, double value, double limit, int digits, FitResult& result)
{
  const double share = value / limit;
  if (share >= NearLimit && share <= 1.0)
  {
    RemarkNear(what + " " + SignificantAgainstLimit(value, limit, digits) + " (limit " +
                   SignificantText(limit, digits) + ")",
               result);
  }
}
} // namespace

TopologyReport ChangesOf(const FitResult& result)
{
  const auto& mapped = result.Details.Mapped;
  TopologyReport report = mapped != nullptr    ? mapped->Topology
                          : result.IsOfSurface ? result.Details.SurfaceRepair
                                               : CavitiesOf(result);
  if (const TopologyChange parts = PartsLeftOut(result); parts.Count > 0)
  {
    report.Add(parts);
  }
  return report;
}

std::string ChangeText(const FitResult& result)
{
  return ChangeText(ChangesOf(result));
}

bool AcceptChanges(const TopologyReport& changes, FitResult& result)
{
  const Status within = CheckTopology(changes, {});
  if (within.IsOk() || result.Settings.Repairs)
  {
    return true;
  }
  const bool isOfParts =
      changes.Bridges.Count > 0 || 2.0 * changes.DroppedParts.Volume > changes.ChangedVolume();
  Refuse(within.Message(), isOfParts ? HintForParts : HintForRepair, result);
  return false;
}

void RemarkOnAcceptance(FitResult& result)
{
  if (result.State != FitResult::Outcome::Fitted)
  {
    return;
  }
  if (const std::string changes = ChangeText(result); !changes.empty())
  {
    result.Message = "is modelled with " + changes;
  }
  for (const TopologyLimitUse& use : UseOfLimits(ChangesOf(result), {}))
  {
    if (use.Share >= NearLimit && use.Share <= 1.0)
    {
      RemarkNear(use.Amount, result);
    }
  }
  if (const auto& mapped = result.Details.Mapped)
  {
    RemarkNear("a map to the sphere that distorts areas by", mapped->Map.AreaDistortion,
               LargestAreaDistortion, 2, result);
    RemarkNear("a surface that overlaps itself in % of the mask:", result.Details.IrregularPercent,
               LargestIrregularPercent, 2, result);
  }
  else if (result.Settings.Model == FitSettings::ModelKind::Radial)
  {
    RemarkNear("a centre that does not see % of the surface:", result.HiddenPercent,
               result.Settings.MaximumHiddenPercent, 3, result);
  }
}
} // namespace palpate
