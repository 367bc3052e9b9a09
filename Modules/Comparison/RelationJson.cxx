#include "RelationJson.h"

#include "JsonNumbers.h"
#include "JsonSchema.h"
#include "RelationTable.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using Json = nlohmann::ordered_json;

Json NumberOrNull(double number)
{
  return std::isfinite(number) ? Json(number) : Json();
}

Json CalibreJson(const RelatedOrgan& organ)
{
  const Calibre& tube = organ.Tube;
  Json json{{"status", tube.Sections.empty() ? "refused" : "measured"},
            {"message", organ.TubeMessage}};
  if (tube.Sections.empty())
  {
    return json;
  }
  json["length_mm"] = tube.Length;
  json["least_diameter_mm"] = tube.At(0.0).Diameter();
  json["median_diameter_mm"] = tube.At(0.5).Diameter();
  json["largest_diameter_mm"] = tube.At(1.0).Diameter();
  for (const CalibreSection& section : tube.Sections)
  {
    json["sections"].push_back({{"along_mm", section.Along},
                                {"center_mm", PointJson(section.Center)},
                                {"axis", PointJson(section.Axis)},
                                {"area_mm2", section.Area},
                                {"diameter_mm", section.Diameter()},
                                {"least_mm", section.Least},
                                {"largest_mm", section.Largest}});
  }
  return json;
}

Json OrganJson(const RelatedOrgan& organ, const OrganMeasures& measures)
{
  Json json{{"name", organ.Name},
            {"file", organ.File.string()},
            {"label", organ.Structure.Label == 0 ? Json() : Json(organ.Structure.Label)},
            {"kind", organ.Kind},
            {"status", organ.IsMeasured() ? "measured" : "refused"},
            {"message", organ.Message},
            {"notes", organ.Notes},
            {"cut_by_border", organ.IsCut}};
  if (!organ.IsMeasured())
  {
    return json;
  }
  json["cut_mm2"] = organ.CutArea;
  json["volume_ml"] = NumberOrNull(organ.Milliliters);
  for (const ShapeFeature& feature : organ.Features)
  {
    json["shape"][KeyWithUnit(feature)] = NumberOrNull(feature.Value);
  }
  json["thickness"] = {{"mean_mm", NumberOrNull(organ.Thick.Mean)},
                       {"p5_mm", NumberOrNull(organ.Thick.Percentile5)},
                       {"median_mm", NumberOrNull(organ.Thick.Median)},
                       {"p95_mm", NumberOrNull(organ.Thick.Percentile95)}};
  if (measures.Calibre)
  {
    json["calibre"] = CalibreJson(organ);
  }
  json["centroid_mm"] = PointJson(organ.Body->Spread().Mean);
  const Eigen::AlignedBox3d& box = organ.Body->Box();
  json["extent_mm"] = {{box.min().x(), box.max().x()},
                       {box.min().y(), box.max().y()},
                       {box.min().z(), box.max().z()}};
  const Matrix3 axes = organ.Body->Spread().Axes();
  json["axes"] = {PointJson(axes.col(0)), PointJson(axes.col(1)), PointJson(axes.col(2))};
  return json;
}

Json RelatedSideJson(const RelatedSide& side)
{
  Json within = Json::array();
  for (const NearShare& share : side.Near)
  {
    within.push_back({{"margin_mm", share.Millimeters},
                      {"area_percent", 100.0 * share.Area},
                      {"volume_percent", 100.0 * share.Volume}});
  }
  return {{"contact_mm2", side.ContactArea}, {"within", within}};
}

Json OrganPairJson(const OrganPair& pair, const std::vector<RelatedOrgan>& organs)
{
  const BodyRelation& found = pair.Relation;
  const OffsetSide side = OffsetSideOf(found.Offset);
  Json first = RelatedSideJson(found.One);
  first["point_mm"] = PointJson(found.Wall.PointOfOne);
  Json second = RelatedSideJson(found.Other);
  second["point_mm"] = PointJson(found.Wall.PointOfOther);
  return {{"first", organs[pair.One].Name},
          {"second", organs[pair.Other].Name},
          {"relation", RelationWord(found.Is)},
          {"distance_mm", found.Distance()},
          {"wall_mm", found.Wall.Distance},
          {"shared_mm3", NumberOrNull(found.SharedVolume)},
          {"of_first", first},
          {"of_second", second},
          {"offset_mm", PointJson(found.Offset)},
          {"side", side.Name},
          {"side_degrees", side.Degrees},
          {"axes_degrees", found.AxesAngle}};
}
} // namespace

std::string RelationJson(const OrganRelations& relations, const std::string& folder)
{
  const OrganMeasures& measures = relations.Measures;
  Json organs = Json::array();
  for (const RelatedOrgan& organ : relations.Organs)
  {
    organs.push_back(OrganJson(organ, measures));
  }
  Json pairs = Json::array();
  for (const OrganPair& pair : relations.Pairs)
  {
    pairs.push_back(OrganPairJson(pair, relations.Organs));
  }
  const Json json{{JsonSchemaKey, JsonSchemaVersion},
                  {"definition", measures.Mesh == MaskMesh::Ibsi ? "ibsi" : "subvoxel"},
                  {"thickness_rule", ThicknessWord(measures.Thickness)},
                  {"keeps_cuts", measures.KeepCuts},
                  {"contact_mm", relations.Settings.Contact},
                  {"organs", organs},
                  {"pairs", pairs},
                  {"folder", folder.empty() ? Json() : Json(folder)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}
} // namespace palpate
