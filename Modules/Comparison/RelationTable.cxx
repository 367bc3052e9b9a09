#include "RelationTable.h"

#include "ComparisonNames.h"
#include "CsvText.h"
#include "DecimalText.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
using Row = std::vector<std::pair<std::string, std::string>>; // keys and values

std::string CellOf(double number)
{
  return std::isfinite(number) ? SignificantText(number, 9) : std::string();
}

void AddPoint(const std::string& key, const Vector3& point, Row& row)
{
  constexpr const char* Axes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis)
  {
    row.emplace_back(key + "_" + Axes[axis] + "_mm", CellOf(point[axis]));
  }
}

void AddCalibre(const Calibre& tube, Row& row)
{
  const auto diameter = [&](double part)
  { return tube.Sections.empty() ? std::nan("") : tube.At(part).Diameter(); };
  row.insert(row.end(),
             {{"calibre_length_mm", CellOf(tube.Sections.empty() ? std::nan("") : tube.Length)},
              {"calibre_least_mm", CellOf(diameter(0.0))},
              {"calibre_median_mm", CellOf(diameter(0.5))},
              {"calibre_largest_mm", CellOf(diameter(1.0))}});
}

Row RowOf(const RelatedOrgan& organ, const std::vector<ShapeFeature>& features,
          const OrganMeasures& measures)
{
  const bool isLabel = organ.Structure.Label != 0;
  Row row{{"name", organ.Name},
          {"file", organ.File.filename().string()},
          {"label", isLabel ? std::to_string(organ.Structure.Label) : ""},
          {"kind", organ.Kind},
          {"status", organ.IsMeasured() ? "measured" : "refused"},
          {"message", organ.Message},
          {"cut_by_border", organ.IsCut ? "yes" : "no"},
          {"cut_mm2", CellOf(organ.CutArea)},
          {"volume_ml", CellOf(organ.Milliliters)}};
  for (const ShapeFeature& feature : features)
  {
    row.emplace_back(KeyWithUnit(feature), CellOf(ValueOf(organ.Features, feature.Key)));
  }
  row.insert(row.end(), {{"thickness_mean_mm", CellOf(organ.Thick.Mean)},
                         {"thickness_p5_mm", CellOf(organ.Thick.Percentile5)},
                         {"thickness_median_mm", CellOf(organ.Thick.Median)},
                         {"thickness_p95_mm", CellOf(organ.Thick.Percentile95)}});
  if (measures.Calibre)
  {
    AddCalibre(organ.Tube, row);
  }
  const Vector3 centroid =
      organ.IsMeasured() ? organ.Body->Spread().Mean : Vector3::Constant(std::nan(""));
  AddPoint("centroid", centroid, row);
  AddPoint("first_axis",
           organ.IsMeasured() ? Vector3(organ.Body->Spread().Axes().col(0)) : centroid, row);
  return row;
}

void AddSide(const std::string& which, const RelatedSide& side, Row& row)
{
  row.emplace_back(which + "_contact_mm2", CellOf(side.ContactArea));
  for (const NearShare& share : side.Near)
  {
    const std::string within = "_within_" + ToleranceText(share.Millimeters) + "mm_percent";
    row.emplace_back(which + "_area" + within, CellOf(100.0 * share.Area));
    row.emplace_back(which + "_volume" + within, CellOf(100.0 * share.Volume));
  }
}

Row RowOf(const OrganPair& pair, const std::vector<RelatedOrgan>& organs)
{
  const BodyRelation& found = pair.Relation;
  const OffsetSide side = OffsetSideOf(found.Offset);
  Row row{{"first", organs[pair.One].Name},         {"second", organs[pair.Other].Name},
          {"relation", RelationWord(found.Is)},     {"distance_mm", CellOf(found.Distance())},
          {"wall_mm", CellOf(found.Wall.Distance)}, {"shared_mm3", CellOf(found.SharedVolume)}};
  AddSide("first", found.One, row);
  AddSide("second", found.Other, row);
  row.insert(row.end(), {{"side", side.Name},
                         {"side_degrees", CellOf(side.Degrees)},
                         {"axes_degrees", CellOf(found.AxesAngle)}});
  AddPoint("offset", found.Offset, row);
  AddPoint("first_point", found.Wall.PointOfOne, row);
  AddPoint("second_point", found.Wall.PointOfOther, row);
  return row;
}

std::string TableOf(const std::vector<Row>& rows)
{
  std::string text;
  for (const Row& row : rows)
  {
    std::vector<std::string> head;
    std::vector<std::string> cells;
    for (const auto& [key, value] : row)
    {
      head.push_back(key);
      cells.push_back(value);
    }
    text += (text.empty() ? CsvLine(head) : "") + CsvLine(cells);
  }
  return text;
}
} // namespace

std::string KeyWithUnit(const ShapeFeature& feature)
{
  const std::string unit = feature.Unit;
  return feature.Key + (unit.empty() ? "" : unit == "1/mm" ? "_per_mm" : "_" + unit);
}

std::string OrganTable(const OrganRelations& relations)
{
  std::vector<ShapeFeature> features; // those of all that are measured
  for (const RelatedOrgan& organ : relations.Organs)
  {
    features = features.empty() ? organ.Features : features;
  }
  std::vector<Row> rows;
  for (const RelatedOrgan& organ : relations.Organs)
  {
    rows.push_back(RowOf(organ, features, relations.Measures));
  }
  return TableOf(rows);
}

std::string CalibreTable(const Calibre& tube)
{
  std::vector<Row> rows;
  for (const CalibreSection& section : tube.Sections)
  {
    Row row{{"along_mm", CellOf(section.Along)},
            {"area_mm2", CellOf(section.Area)},
            {"diameter_mm", CellOf(section.Diameter())},
            {"least_mm", CellOf(section.Least)},
            {"largest_mm", CellOf(section.Largest)}};
    AddPoint("center", section.Center, row);
    rows.push_back(std::move(row));
  }
  return TableOf(rows);
}

std::string OrganPairTable(const OrganRelations& relations)
{
  std::vector<Row> rows;
  for (const OrganPair& pair : relations.Pairs)
  {
    rows.push_back(RowOf(pair, relations.Organs));
  }
  return TableOf(rows);
}
} // namespace palpate
