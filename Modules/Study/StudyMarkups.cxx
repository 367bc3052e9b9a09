#include "StudyMarkups.h"

#include "CsvText.h"
#include "DecimalText.h"
#include "Refusal.h"
#include "WholeFile.h"

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

OrderedJson ControlPoint(const std::string& id, const std::string& label, const Vector3& place)
{
  return {{"id", id}, {"label", label}, {"position", {place[0], place[1], place[2]}}};
}

OrderedJson Markup(const char* type, OrderedJson points)
{
  return {{"type", type},
          {"coordinateSystem", "LPS"},
          {"coordinateUnits", "mm"},
          {"controlPoints", std::move(points)}};
}

OrderedJson PointsOf(const std::vector<StudyLandmark>& landmarks)
{
  OrderedJson points = OrderedJson::array();
  for (const StudyLandmark& landmark : landmarks)
  {
    points.push_back(
        ControlPoint(std::to_string(points.size() + 1), landmark.Name, landmark.PositionWorld));
  }
  return Markup("Fiducial", std::move(points));
}

OrderedJson LineOf(const StudyDistance& distance)
{
  OrderedJson line = Markup("Line", {ControlPoint("1", distance.Name + "-1", distance.FromWorld),
                                     ControlPoint("2", distance.Name + "-2", distance.ToWorld)});
  line["measurements"] = OrderedJson::array(
      {{{"name", "length"}, {"enabled", true}, {"value", distance.Length()}, {"units", "mm"}}});
  return line;
}

std::string SlicerText(const std::filesystem::path& path,
                       const std::vector<StudyLandmark>& landmarks,
                       const std::vector<StudyDistance>& distances)
{
  OrderedJson markups = OrderedJson::array();
  if (!landmarks.empty())
  {
    markups.push_back(PointsOf(landmarks));
  }
  for (const StudyDistance& distance : distances)
  {
    markups.push_back(LineOf(distance));
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

std::string TableOf(const std::vector<StudyLandmark>& landmarks,
                    const std::vector<StudyDistance>& distances)
{
  std::string text = CsvLine(
      {"kind", "name", "x_mm", "y_mm", "z_mm", "to_x_mm", "to_y_mm", "to_z_mm", "length_mm"});
  for (const StudyLandmark& landmark : landmarks)
  {
    const Vector3& at = landmark.PositionWorld;
    text += CsvLine({"landmark", landmark.Name, ExactText(at[0]), ExactText(at[1]),
                     ExactText(at[2]), "", "", "", ""});
  }
  for (const StudyDistance& distance : distances)
  {
    const Vector3& from = distance.FromWorld;
    const Vector3& to = distance.ToWorld;
    text += CsvLine({"distance", distance.Name, ExactText(from[0]), ExactText(from[1]),
                     ExactText(from[2]), ExactText(to[0]), ExactText(to[1]), ExactText(to[2]),
                     ExactText(distance.Length())});
  }
  return text;
}
} // namespace

void WriteMarkups(const std::filesystem::path& path, const std::vector<StudyLandmark>& landmarks,
                  const std::vector<StudyDistance>& distances)
{
  if (landmarks.empty() && distances.empty())
  {
    Refuse(path, "was not written, since there are no markups",
           "place a landmark or a distance first");
  }
  const std::string name = path.filename().string();
  if (EndsWith(name, ".mrk.json"))
  {
    WriteWholeFile(path, SlicerText(path, landmarks, distances));
  }
  else if (EndsWith(name, ".csv"))
  {
    WriteWholeFile(path, TableOf(landmarks, distances));
  }
  else
  {
    Refuse(path, "has no ending of a markups format", "use .mrk.json or .csv");
  }
}
} // namespace palpate
