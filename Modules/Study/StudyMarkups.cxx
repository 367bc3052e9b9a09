#include "StudyMarkups.h"

#include "CsvText.h"
#include "DecimalText.h"
#include "PointMeasures.h"
#include "Refusal.h"
#include "WholeFile.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using OrderedJson = nlohmann::ordered_json;

// Slicer's documentation of the format: "Markups json file format".
constexpr const char* Schema =
    "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/"
    "Schema/markups-schema-v1.0.3.json#";

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

OrderedJson Triple(const Vector3& vector)
{
  return {vector[0], vector[1], vector[2]};
}

OrderedJson NewMarkup(const char* type, const std::string& name)
{
  return {{"type", type},
          {"name", name},
          {"coordinateSystem", "LPS"},
          {"coordinateUnits", "mm"},
          {"controlPoints", OrderedJson::array()}};
}

void AddControlPoint(OrderedJson& markup, const std::string& label, const Vector3& place)
{
  OrderedJson& points = markup["controlPoints"];
  points.push_back({{"id", std::to_string(points.size() + 1)},
                    {"label", label},
                    {"position", Triple(place)},
                    {"positionStatus", "defined"}});
}

const char* TypeOf(MeasurementKind kind)
{
  switch (kind)
  {
  case MeasurementKind::Angle:
    return "Angle";
  case MeasurementKind::Curve:
  case MeasurementKind::SurfaceCurve:
    return "Curve";
  case MeasurementKind::Plane:
    return "Plane";
  default:
    return "Line";
  }
}

OrderedJson MarkupOf(const StudyMeasurement& measurement)
{
  OrderedJson markup = NewMarkup(TypeOf(measurement.Kind), measurement.Name);
  for (const Vector3& place : measurement.Line())
  {
    AddControlPoint(
        markup, measurement.Name + "-" + std::to_string(markup["controlPoints"].size() + 1), place);
  }
  const std::vector<Vector3>& points = measurement.PointsWorld;
  if (measurement.Kind == MeasurementKind::Plane)
  {
    markup["planeType"] = "threePoints";
    markup["center"] = Triple(LabelPlaceOf(measurement));
    markup["normal"] = Triple(PlaneNormal(points[0], points[1], points[2]));
  }
  if (const std::optional<double> value = ValueOf(measurement))
  {
    const char* name = measurement.Kind == MeasurementKind::Angle ? "angle" : "length";
    markup["measurements"] = OrderedJson::array({{{"name", name},
                                                  {"enabled", true},
                                                  {"value", *value},
                                                  {"units", UnitOf(measurement.Kind)}}});
  }
  return markup;
}

std::string SlicerText(const std::filesystem::path& path, const StudyMarkups& all)
{
  OrderedJson markups = OrderedJson::array();
  if (!all.Landmarks.empty())
  {
    OrderedJson list = NewMarkup("Fiducial", "Landmarks");
    for (const StudyLandmark& landmark : all.Landmarks)
    {
      AddControlPoint(list, landmark.Name, landmark.PositionWorld);
    }
    markups.push_back(std::move(list));
  }
  for (const StudyMeasurement& measurement : all.Measurements)
  {
    markups.push_back(MarkupOf(measurement));
  }
  try
  {
    return OrderedJson{{"@schema", Schema}, {"markups", markups}}.dump(2) + "\n";
  }
  catch (const OrderedJson::type_error&)
  {
    Refuse(path, "cannot be written: it contains a name that is not UTF-8", "rename the landmark");
  }
}

std::string TableLine(const std::string& kind, const std::string& name, std::size_t number,
                      const Vector3& place, const std::string& value, const std::string& unit)
{
  return CsvLine({kind, name, std::to_string(number), ExactText(place[0]), ExactText(place[1]),
                  ExactText(place[2]), value, unit});
}

std::string TableOf(const StudyMarkups& all)
{
  std::string text = CsvLine({"kind", "name", "point", "x_mm", "y_mm", "z_mm", "value", "unit"});
  for (const StudyLandmark& landmark : all.Landmarks)
  {
    text += TableLine("Landmark", landmark.Name, 1, landmark.PositionWorld, "", "");
  }
  for (const StudyMeasurement& measurement : all.Measurements)
  {
    const std::optional<double> value = ValueOf(measurement);
    std::size_t number = 0;
    for (const Vector3& place : measurement.PointsWorld)
    {
      text += TableLine(NameOf(measurement.Kind), measurement.Name, ++number, place,
                        value ? ExactText(*value) : "", value ? UnitOf(measurement.Kind) : "");
    }
  }
  return text;
}
} // namespace

StudyMarkups MarkupsOf(const StudyState& state)
{
  StudyMarkups markups{state.Landmarks, {}};
  std::copy_if(state.Measurements.begin(), state.Measurements.end(),
               std::back_inserter(markups.Measurements),
               [](const StudyMeasurement& one) { return !one.IsOpen; });
  return markups;
}

bool IsMarkupsFile(const std::filesystem::path& file)
{
  return EndsWith(file.filename().string(), ".mrk.json");
}

void WriteMarkups(const std::filesystem::path& path, const StudyMarkups& markups)
{
  if (markups.IsEmpty())
  {
    Refuse(path, "was not written, since there are no markups",
           "place a landmark or a measurement first");
  }
  if (IsMarkupsFile(path))
  {
    WriteWholeFile(path, SlicerText(path, markups));
  }
  else if (EndsWith(path.filename().string(), ".csv"))
  {
    WriteWholeFile(path, TableOf(markups));
  }
  else
  {
    Refuse(path, "has no ending of a markups format", "use .mrk.json or .csv");
  }
}
} // namespace palpate
