#include "ComparisonJson.h"

#include "CaseText.h"
#include "ComparisonNames.h"
#include "JsonNumbers.h"
#include "JsonSchema.h"
#include "PatientSides.h"
#include "Units.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using Json = nlohmann::ordered_json;

Json OrNull(double number)
{
  return std::isfinite(number) ? Json(number) : Json();
}

Json SideJson(const ComparedSide& side, bool isCompared)
{
  return {{"file", side.File.string()},
          {"label", side.Structure.Label == 0 ? Json() : Json(side.Structure.Label)},
          {"name", side.Structure.Name},
          {"kind", side.Kind},
          {"volume_ml", isCompared ? OrNull(side.Milliliters) : Json()},
          {"area_mm2", isCompared ? OrNull(side.Area) : Json()},
          {"holes", side.Holes}};
}

Json OverlapJson(const std::optional<BodyOverlap>& overlap)
{
  if (!overlap)
  {
    return nullptr;
  }
  constexpr const char* Cells[] = {"voxels", "mask-voxels", "cubes", "none"};
  const Vector3& spacing = overlap->Spacing;
  const bool hasCells = overlap->Kind != BodyOverlap::Cells::None;
  return {{"dice", overlap->Dice()},
          {"jaccard", overlap->Jaccard()},
          {"cells", Cells[static_cast<std::size_t>(overlap->Kind)]},
          {"spacing_mm", hasCells ? Json{spacing.x(), spacing.y(), spacing.z()} : Json()}};
}

Json SummaryJson(const DistanceSummary& summary)
{
  return {{"mean_mm", summary.Mean},
          {"rms_mm", summary.Rms},
          {"p95_mm", summary.Percentile95},
          {"max_mm", summary.Largest}};
}

Json DirectionJson(const DistanceMap& map)
{
  Json json = SummaryJson(map.Unsigned);
  json["signed_mean_mm"] = OrNull(map.SignedMean);
  return json;
}

Json BiasJson(const std::optional<SideBias>& bias)
{
  if (!bias)
  {
    return nullptr;
  }
  const auto part = [](const std::string& name, const SideBias::Part& one)
  {
    return Json{{"name", name}, {"mean_mm", OrNull(one.Mean)}, {"area_percent", 100.0 * one.Share}};
  };
  Json sides = Json::array();
  for (std::size_t side = 0; side < PatientSides().size(); ++side)
  {
    sides.push_back(part(PatientSides()[side].Name, bias->Sides[side]));
  }
  Json octants = Json::array();
  for (std::size_t octant = 0; octant < bias->Octants.size(); ++octant)
  {
    octants.push_back(part(OctantName(octant), bias->Octants[octant]));
  }
  return {{"sides", sides}, {"octants", octants}};
}

Json MirrorJson(const PairComparison& pair)
{
  if (!pair.Mirror)
  {
    return nullptr;
  }
  const Vector3& shift = pair.Mirror->Shift;
  return {{"turn_deg", pair.Mirror->Turn * DegreesPerRadian},
          {"shift_mm", PointJson(shift)},
          {"volume_asymmetry_percent", OrNull(pair.VolumeAsymmetryPercent())},
          {"shape_asymmetry_percent", OrNull(pair.ShapeAsymmetryPercent())}};
}

Json MotionJson(const PairComparison& pair)
{
  if (!pair.Motion)
  {
    return nullptr;
  }
  Json landmarks = Json::array();
  for (const Vector3& landmark : pair.Motion->Landmarks)
  {
    landmarks.push_back(PointJson(landmark));
  }
  return {{"turn_deg", pair.Motion->Turn * DegreesPerRadian},
          {"shift_mm", PointJson(pair.Motion->Shift)},
          {"rest_mm", pair.Motion->Rest},
          {"landmarks_mm", landmarks}};
}

Json NumbersJson(const PairComparison& pair)
{
  const BodyComparison& found = pair.Numbers;
  Json tolerances = Json::array();
  for (const BodyComparison::Tolerance& tolerance : found.Tolerances)
  {
    tolerances.push_back(
        {{"tolerance_mm", tolerance.Millimeters}, {"value", tolerance.SurfaceDice}});
  }
  return {{"overlap", OverlapJson(found.Overlap)},
          {"volume_difference_ml", OrNull(pair.VolumeDifference())},
          {"volume_difference_percent", OrNull(pair.VolumeDifferencePercent())},
          {"distance",
           {{"both", SummaryJson(found.Both)},
            {"first_to_reference", DirectionJson(found.OneToOther)},
            {"reference_to_first", DirectionJson(found.OtherToOne)},
            {"hausdorff95_mm", found.Hausdorff95()},
            {"least_mm", found.LeastDistance}}},
          {"surface_dice", tolerances},
          {"bias", BiasJson(found.Bias)},
          {"mirror", MirrorJson(pair)},
          {"motion", MotionJson(pair)},
          {"seconds", pair.Seconds}};
}
} // namespace

std::string ComparisonJson(const PairComparison& pair, const std::string& folder)
{
  Json json{{JsonSchemaKey, JsonSchemaVersion},
            {"case", pair.Case},
            {"time", pair.Time ? Json(*pair.Time) : Json()},
            {"first", SideJson(pair.One, pair.IsCompared())},
            {"reference", SideJson(pair.Other, pair.IsCompared())},
            {"status", pair.IsCompared() ? "compared" : TextOf(pair.State).Word},
            {"message", pair.Message},
            {"notes", pair.Notes}};
  if (pair.IsCompared())
  {
    json.update(NumbersJson(pair));
    json["folder"] = folder.empty() ? Json() : Json(folder);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}
} // namespace palpate
