#include "FitJson.h"

#include "CaseText.h"
#include "JsonNumbers.h"
#include "JsonSchema.h"
#include "StructureChanges.h"
#include "Units.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <utility>

namespace palpate
{
namespace
{
using Json = nlohmann::ordered_json;

Json DistancesJson(const SurfaceDistances& distances)
{
  return {{"mean_mm", distances.Mean},
          {"rms_mm", distances.Rms},
          {"p95_mm", distances.Percentile95},
          {"max_mm", distances.Maximum}};
}

Json StarJson(const FitResult& result)
{
  if (!result.IsSampled)
  {
    return {{"star_shaped", nullptr},
            {"hidden_percent", nullptr},
            {"multiple_percent", nullptr},
            {"missed_percent", nullptr}};
  }
  return {{"star_shaped", result.StarShaped},
          {"hidden_percent", result.HiddenPercent},
          {"multiple_percent", result.MultiplePercent},
          {"missed_percent", result.MissedPercent}};
}

Json CoverageJson(const DirectionCoverage& coverage)
{
  const Vector3& gap = coverage.LargestGap.Center;
  return {{"verdict", CoverageWord(coverage)},
          {"message", coverage.Message},
          {"largest_gap_degrees", coverage.LargestGap.Radius * DegreesPerRadian},
          {"gap_direction", PointJson(gap)},
          {"noise_gain_rms", coverage.NoiseGainRms},
          {"noise_gain_max", coverage.NoiseGainMaximum}};
}

// One entry for each kind of change that was made.
Json ChangesJson(const TopologyReport& report)
{
  Json changes = Json::array();
  for (const auto& [kind, change] :
       {std::pair("dropped_parts", &report.DroppedParts), std::pair("bridges", &report.Bridges),
        std::pair("filled_cavities", &report.FilledCavities),
        std::pair("cut_handles", &report.CutHandles),
        std::pair("filled_handles", &report.FilledHandles)})
  {
    if (change->Count > 0)
    {
      const Vector3& center = change->LargestCentre;
      changes.push_back({{"kind", kind},
                         {"count", change->Count},
                         {"mm3", change->Volume},
                         {"largest_mm3", change->LargestVolume},
                         {"largest_extent_mm", change->LargestExtent},
                         {"largest_center_mm", PointJson(center)}});
    }
  }
  return changes;
}

// What the repair of the topology changed; null of a radial model.
Json RepairJson(const FitResult& result)
{
  const auto& mapped = result.Details.Mapped;
  if (mapped == nullptr)
  {
    return nullptr;
  }
  return {{"changed_percent", mapped->Topology.ChangedPercent()},
          {"changes", ChangesJson(mapped->Topology)},
          {"added_area_percent", result.Details.AddedAreaPercent},
          {"lost_places", mapped->Lost.size()},
          {"lost_mm", mapped->Lost.empty() ? 0.0 : mapped->Lost.front().Distance}};
}

Json ParametrisationJson(const FitResult& result)
{
  const auto& mapped = result.Details.Mapped;
  if (mapped == nullptr)
  {
    return nullptr;
  }
  return {{"area_distortion", mapped->Map.AreaDistortion},
          {"least_area_ratio", mapped->Map.LeastRatio},
          {"determination", result.Details.Determination}};
}

Json CrossingsJson(const FitResult& result, bool fitted)
{
  if (!fitted || result.Details.Mapped == nullptr)
  {
    return nullptr;
  }
  return {{"pairs", result.Details.Crossings},
          {"folded_vertices", result.Details.Folded},
          {"irregular_percent", result.Details.IrregularPercent}};
}

Json FitJsonOf(const FitResult& result, bool fitted)
{
  if (!fitted)
  {
    return {{"condition", nullptr}, {"rms_mm", nullptr}};
  }
  const Vector3 center = CenterOf(result.Model);
  return {{"condition", result.Condition},
          {"rms_mm", result.Rms},
          {"noise_mm", result.NoiseDeviation},
          {"roughness", result.Roughness},
          {"degrees_of_freedom", result.DegreesOfFreedom},
          {"down_weighted", result.DownWeighted},
          {"coverage", CoverageJson(result.Coverage)},
          {"rms_by_degree_mm", result.RmsByDegree},
          {"center_mm", PointJson(center)},
          {"power_mm2", PowerSpectrumOf(result.Model)}};
}

Json QualityJson(const FitResult& result, bool fitted)
{
  const Json nothing = {
      {"mean_mm", nullptr}, {"rms_mm", nullptr}, {"p95_mm", nullptr}, {"max_mm", nullptr}};
  Json noMask = {{"dice", nullptr}};
  noMask.update(nothing);
  const Json noOverlap = {{"dice", nullptr}, {"spacing_mm", nullptr}};
  if (!fitted)
  {
    return {{"mask", noMask},
            {"overlap", noOverlap},
            {"surface", nothing},
            {"surface_to_mask", nothing}};
  }
  if (result.IsOfSurface)
  {
    return {{"mask", noMask},
            {"overlap", {{"dice", result.Dice}, {"spacing_mm", result.DiceSpacing}}},
            {"surface", DistancesJson(result.ModelToSurface)},
            {"surface_to_mask", nothing}};
  }
  Json mask = {{"dice", result.Dice}};
  mask.update(DistancesJson(result.ModelToMask));
  return {{"mask", mask},
          {"overlap", noOverlap},
          {"surface", DistancesJson(result.ModelToSurface)},
          {"surface_to_mask", DistancesJson(result.SurfaceToMask)}};
}

} // namespace

std::string FitResultJson(const FitResult& result, const std::string& folder)
{
  const bool fitted = result.State == FitResult::Outcome::Fitted;
  const bool measured = !result.ComponentMilliliters.empty();
  Json json;
  json[JsonSchemaKey] = JsonSchemaVersion;
  json["input"] = result.Input.string();
  // Background is not a structure: it stands for a file that cannot be read, or a name that it
  // lacks.
  json["label"] = result.Structure.Label == 0 ? Json() : Json(result.Structure.Label);
  json["name"] = result.Structure.Name;
  json["degree"] = fitted ? DegreeOf(result.Model) : result.Settings.Degree;
  json["status"] = TextOf(result.State).Word;
  json["message"] = fitted ? std::string() : result.Message;
  json["changes"] = fitted ? ChangeText(result) : std::string();
  json["notes"] = result.Notes;
  json["star"] = StarJson(result);
  json["fit"] = FitJsonOf(result, fitted);
  const bool isSurface =
      result.Details.Mapped != nullptr || result.Settings.Model == FitSettings::ModelKind::Surface;
  json["model"] = isSurface ? "surface" : "radial";
  json["repair"] = RepairJson(result);
  json["parametrisation"] = ParametrisationJson(result);
  json["crossings"] = CrossingsJson(result, fitted);
  json["quality"] = QualityJson(result, fitted);
  const auto orNull = [](bool known, double value) { return known ? Json(value) : Json(); };
  const bool hasSurface = result.IsOfSurface && result.Surface != nullptr;
  json["volume_ml"] = {{"mask", orNull(measured, result.MaskMilliliters)},
                       {"surface", orNull(measured || hasSurface, result.SurfaceMilliliters)},
                       {"model", orNull(fitted, result.ModelMilliliters)}};
  json["area_mm2"] = {{"surface", orNull(fitted, result.SurfaceAreaSquareMillimeters)},
                      {"model", orNull(fitted, result.ModelAreaSquareMillimeters)}};
  json["touches_border"] = result.TouchesBorder;
  json["components_ml"] = result.ComponentMilliliters;
  json["cavities"] = {{"count", result.CavityCount}, {"ml", result.CavityMilliliters}};
  Json seconds = Json::object();
  for (const auto& [stage, time] : result.Seconds)
  {
    seconds[stage] = time;
  }
  json["seconds"] = seconds;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  json["peak_memory_mb"] = static_cast<double>(usage.ru_maxrss) / 1024.0; // of the process so far
  json["folder"] = folder.empty() ? Json() : Json(folder);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}
} // namespace palpate
