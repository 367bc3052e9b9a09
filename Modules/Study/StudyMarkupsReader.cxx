#include "StudyMarkupsReader.h"

#include "JsonFields.h"
#include "JsonText.h"
#include "Refusal.h"

#include <cstdint>
#include <map>

namespace palpate
{
namespace
{
using nlohmann::json;

constexpr std::uintmax_t LargestMarkupsFile = 16 << 20;
constexpr std::size_t MostMarkups = 2000;
constexpr double LargestMarkupPlace = 1e6; // mm
constexpr double LargestEntry = 1e9;       // um
constexpr const char* Remedy = "save it again in 3D Slicer";

// Types that are read. ROIs and those of extensions are not.
const std::map<std::string, MeasurementKind> KindByType{{"Line", MeasurementKind::Line},
                                                        {"Angle", MeasurementKind::Angle},
                                                        {"Curve", MeasurementKind::Curve},
                                                        {"ClosedCurve", MeasurementKind::Curve},
                                                        {"Plane", MeasurementKind::Plane}};

struct ControlPoint
{
  std::string Label;
  Vector3 Place = Vector3::Zero();
};

// An object of the file, and how its coordinates become mm in LPS.
class SlicerMarkup
{
public:
  SlicerMarkup(const json& object, const std::filesystem::path& file, const std::string& place)
      : Object(object), File(file), Place(place), Fields(object, file, place)
  {
    this->Fields.Exchange("type", this->Type);
    this->Fields.Exchange("name", this->Name);
    std::string frame = "LPS";
    this->Fields.Exchange("coordinateSystem", frame, std::vector<std::string>{"LPS", "RAS"});
    this->Side = frame == "RAS" ? -1.0 : 1.0;
    this->TakeUnit();
  }

  // By label, of the points that were placed.
  std::vector<ControlPoint> Points() const
  {
    std::vector<ControlPoint> points;
    const json list = this->Object.value("controlPoints", json::array());
    this->Require(list.is_array(), "has control points that are no list");
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      const std::string place = this->Place + ".controlPoints[" + std::to_string(i) + "]";
      JsonFields fields(list[i], this->File, place);
      std::string status = "defined";
      fields.Exchange("positionStatus", status,
                      std::vector<std::string>{"undefined", "preview", "defined"});
      if (status == "defined" && list[i].contains("position"))
      {
        ControlPoint point;
        fields.Exchange("label", point.Label);
        point.Place = this->ToWorld(fields, "position");
        points.push_back(point);
      }
    }
    return points;
  }

  bool Has(const char* key) const { return this->Object.contains(key); }
  Vector3 PlaceOf(const char* key) { return this->ToWorld(this->Fields, key); }
  Vector3 DirectionOf(const char* key)
  {
    Vector3 direction = Vector3::Zero();
    this->Fields.Exchange(key, direction, -1.0 - 1e-6, 1.0 + 1e-6);
    return Vector3(this->Side * direction.x(), this->Side * direction.y(), direction.z());
  }
  void Require(bool isFulfilled, const std::string& fact) const
  {
    this->Fields.Require(isFulfilled, "cannot be read: its " + this->Place + " " + fact, Remedy);
  }

  std::string Type;
  std::string Name;

private:
  // A word, or a list of code, scheme and meaning.
  void TakeUnit()
  {
    const auto found = this->Object.find("coordinateUnits");
    if (found != this->Object.end())
    {
      const json& code = found->is_array() && !found->empty() ? found->front() : *found;
      this->Require(code == "mm" || code == "um", "has another unit than mm or um");
      this->Scale = code == "um" ? 1e-3 : 1.0;
    }
  }
  Vector3 ToWorld(JsonFields& fields, const char* key) const
  {
    Vector3 place = Vector3::Zero();
    fields.Exchange(key, place, -LargestEntry, LargestEntry);
    place *= this->Scale;
    fields.Require(place.cwiseAbs().maxCoeff() <= LargestMarkupPlace,
                   "cannot be read: its " + fields.Place() + " is more than 1e6 mm away", Remedy);
    return Vector3(this->Side * place.x(), this->Side * place.y(), place.z());
  }

  const json& Object;
  std::filesystem::path File;
  std::string Place;
  JsonFields Fields;
  double Side = 1.0;  // of x and y
  double Scale = 1.0; // mm per unit
};

std::vector<Vector3> PlacesOf(const std::vector<ControlPoint>& points)
{
  std::vector<Vector3> places;
  for (const ControlPoint& point : points)
  {
    places.push_back(point.Place);
  }
  return places;
}

// A plane of a point and a normal, or one that was fitted to its points.
std::vector<Vector3> PlanePoints(SlicerMarkup& markup, const std::vector<Vector3>& points)
{
  constexpr double Arm = 10.0; // mm
  const Vector3 normal = markup.DirectionOf("normal");
  markup.Require(normal.norm() > 0.5, "is a plane without its normal");
  markup.Require(!points.empty() || markup.Has("center"), "is a plane without a point");
  const Vector3 center = markup.Has("center") ? markup.PlaceOf("center") : points.front();
  const Vector3 one = normal.unitOrthogonal();
  return {center, center + Arm * one, center + Arm * normal.normalized().cross(one)};
}

bool IsOfThreePoints(const json& object, std::size_t count)
{
  return count == 3 && object.value("planeType", json("threePoints")) == "threePoints";
}

void TakeLandmarks(const SlicerMarkup& markup, StudyMarkups& all)
{
  for (const ControlPoint& point : markup.Points())
  {
    const std::string number = std::to_string(all.Landmarks.size() + 1);
    all.Landmarks.push_back({point.Label.empty() ? "F-" + number : point.Label, point.Place});
  }
}

void TakeMeasurement(SlicerMarkup& markup, const json& object, StudyMarkups& all)
{
  StudyMeasurement read;
  read.Kind = KindByType.at(markup.Type);
  read.PointsWorld = PlacesOf(markup.Points());
  if (markup.Type == "ClosedCurve" && !read.PointsWorld.empty())
  {
    read.PointsWorld.push_back(read.PointsWorld.front());
  }
  if (markup.Type == "Plane" && !IsOfThreePoints(object, read.PointsWorld.size()))
  {
    read.PointsWorld = PlanePoints(markup, read.PointsWorld);
  }
  if (HasValidPoints(read))
  {
    const std::string number = std::to_string(all.Measurements.size() + 1);
    read.Name = markup.Name.empty() ? markup.Type + " " + number : markup.Name;
    all.Measurements.push_back(read);
  }
}
} // namespace

StudyMarkups ReadMarkups(const std::filesystem::path& path)
{
  const json root = ReadJson(path, LargestMarkupsFile, Remedy);
  if (!root.is_object() || !root.contains("markups") || !root["markups"].is_array())
  {
    Refuse(path, "is not a markups file of 3D Slicer", "open another file");
  }
  StudyMarkups all;
  std::size_t number = 0;
  for (const json& object : root["markups"])
  {
    SlicerMarkup markup(object, path, "markups[" + std::to_string(number++) + "]");
    if (markup.Type == "Fiducial")
    {
      TakeLandmarks(markup, all);
    }
    else if (KindByType.count(markup.Type) > 0)
    {
      TakeMeasurement(markup, object, all);
    }
    if (all.Landmarks.size() + all.Measurements.size() > MostMarkups)
    {
      Refuse(path, "has more than " + std::to_string(MostMarkups) + " landmarks and measurements",
             "split it in 3D Slicer");
    }
  }
  if (all.IsEmpty())
  {
    Refuse(path, "has no points, lines, angles, curves or planes that were placed", Remedy);
  }
  return all;
}
} // namespace palpate
