#include "SceneJson.h"

#include "ContactLimits.h"
#include "DrillLimits.h"
#include "FitSettingsJson.h"
#include "RetiredKeys.h"
#include "SceneEffect.h"
#include "SceneRepresentation.h"
#include "SceneTissue.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double LargestPlace = 1e6;  // mm, of coordinates
constexpr double LargestLength = 1e4; // mm, of tools and guides
constexpr double LargestIso = 1e300;
constexpr int LargestId = 2'000'000'000;

const std::initializer_list<const char*> InterpolationWords{"linear", "cubic"};
const std::initializer_list<const char*> ModeWords{"nearest", "radial"};
const std::initializer_list<const char*> LeftHandedWords{"refuse", "reverse"};
const std::initializer_list<const char*> AppearanceWords{"automatic", "model",     "surface",
                                                         "error-map", "sub-voxel", "stiffness-map"};
const std::initializer_list<const char*> AxesWords{"patient", "camera"};
const std::initializer_list<const char*> GuideWords{"point",  "path",    "plane",
                                                    "inside", "outside", "surface"};
const std::initializer_list<const char*> ShapeWords{"sphere",    "capsule",  "drill",
                                                    "ellipsoid", "cylinder", "surface"};

void ExchangeWord(JsonFields& fields, const SceneNumber& number, double& value)
{
  std::string word = number.Words.at(static_cast<std::size_t>(value));
  if (fields.IsReading() || value != 0.0)
  {
    fields.Exchange(number.Key.c_str(), word, number.Words);
  }
  const auto found = std::find(number.Words.begin(), number.Words.end(), word);
  value = static_cast<double>(found - number.Words.begin());
}

void ExchangeNumbers(JsonFields& fields, const std::vector<SceneNumber>& numbers,
                     SceneStructure& structure)
{
  for (const SceneNumber& number : numbers)
  {
    double value = structure.Number(number.Key);
    if (!number.Words.empty())
    {
      ExchangeWord(fields, number, value);
    }
    else if (number.Decimals == 0)
    {
      int whole = static_cast<int>(value);
      fields.ExchangeIfSet(number.Key.c_str(), whole, 0, static_cast<int>(number.Largest));
      value = whole;
    }
    else
    {
      fields.ExchangeIfSet(number.Key.c_str(), value, number.Least, number.Largest);
    }
    structure.SetNumber(number.Key, value);
  }
}

void ExchangeImage(JsonFields& fields, const std::string& key, SceneStructure& structure)
{
  if (!key.empty())
  {
    std::filesystem::path image = structure.Image(key);
    fields.ExchangeIfSet(key.c_str(), image);
    structure.SetImage(key, image);
  }
}

void ExchangeRepresentation(JsonFields& fields, SceneStructure& structure)
{
  std::vector<std::string> names;
  for (const SceneRepresentation& representation : SceneRepresentations())
  {
    names.push_back(representation.Name);
    ExchangeNumbers(fields, representation.Numbers, structure);
    ExchangeImage(fields, representation.ImageKey, structure);
  }
  ExchangeNumbers(fields, SurroundingNumbers(), structure);
  fields.Exchange("representation", structure.Representation, names);
}

void ExchangeEffects(JsonFields& fields, SceneStructure& structure)
{
  for (const SceneEffectKind& kind : SceneEffectKinds())
  {
    ExchangeNumbers(fields, kind.Numbers, structure);
    ExchangeImage(fields, kind.ImageKey, structure);
  }
}

void ExchangeDrillLaw(JsonFields& fields, DrillLaw& law)
{
  fields.Exchange("wear_mm_per_nm", law.Wear, 0.0, DrillLimits::Wear);
  fields.Exchange("drag_s_per_mm", law.Drag, 0.0, DrillLimits::Drag);
  fields.Exchange("vibration", law.Vibration, 0.0, 1.0);
}

// A number or a name, like those of structures.
void ExchangeWithinLabel(JsonFields& fields, SceneStructure& structure)
{
  std::vector<std::string> labels;
  if (!structure.WithinLabel.empty())
  {
    labels.push_back(structure.WithinLabel);
  }
  fields.ExchangeIfSet("within_label", labels);
  fields.Require(labels.size() <= 1, "limits " + fields.Place() + " to several labels",
                 "name one of them in \"within_label\"");
  structure.WithinLabel = labels.empty() ? std::string() : labels.front();
}

// Written only if set, so that earlier versions read all other scenes.
void ExchangeMove(JsonFields& fields, SceneMove& move)
{
  fields.ExchangeIfSet("transform", move.File);
  fields.ExchangeIfSet("transform_fixed", move.Fixed);
  fields.Require(move.IsSet() || move.Fixed.empty(),
                 "gives " + fields.Place() + " \"transform_fixed\" without \"transform\"",
                 "give both, or remove it");
}

// Only an iso-value is limited or chooses a series.
void ExchangeLimits(JsonFields& fields, SceneStructure& structure)
{
  fields.Exchange("iso_upper", structure.IsoUpper, -LargestIso, LargestIso);
  fields.ExchangeIfSet("within", structure.WithinFile);
  ExchangeWithinLabel(fields, structure);
  fields.ExchangeIfSet("series", structure.Series);
  const bool isPlain = !structure.IsoUpper && structure.WithinFile.empty() &&
                       structure.WithinLabel.empty() && structure.Series.empty();
  fields.Require(isPlain || structure.Iso, "limits " + fields.Place() + ", which has no iso-value",
                 "add \"iso\" there, or remove \"iso_upper\", \"within\", \"within_label\" and "
                 "\"series\"");
  fields.Require(!structure.IsoUpper || *structure.IsoUpper > structure.Iso,
                 "gives " + fields.Place() + " an upper value that is not above its iso-value",
                 "raise \"iso_upper\" there");
  fields.Require(structure.WithinFile.empty() == structure.WithinLabel.empty(),
                 "gives " + fields.Place() + " only one of \"within\" and \"within_label\"",
                 "give both: a segmentation, and the number or name of its label");
}

void ExchangeSource(JsonFields& fields, SceneStructure& structure)
{
  fields.ExchangeIfSet("id", structure.Id, 0, LargestId);
  fields.ExchangeIfSet("name", structure.Name);
  fields.Exchange("file", structure.File);
  fields.Require(!structure.File.empty(), "cannot be read: " + fields.Place() + " has no file",
                 "name a model, a surface, a segmentation or an image in its entry \"file\"");
  fields.ExchangeIfSet("label", structure.Labels);
  fields.Exchange("iso", structure.Iso, -LargestIso, LargestIso);
  ExchangeLimits(fields, structure);
  ExchangeMove(fields, structure.Move);
}

void ExchangeStructure(JsonFields& fields, SceneStructure& structure)
{
  fields.Skip(RetiredKeys::SceneStructure);
  ExchangeSource(fields, structure);
  fields.Exchange("seen", structure.IsVisible);
  fields.Exchange("color", structure.Color, 0.0, 1.0);
  // Written only if set, so that earlier versions read all other scenes.
  if (fields.IsReading() || structure.Opacity != 1.0)
  {
    fields.Exchange("opacity", structure.Opacity, 0.0, 1.0);
  }
  fields.Exchange("shown_as", structure.Appearance, AppearanceWords);
  fields.Exchange("touched", structure.IsTouchable);
  ExchangeRepresentation(fields, structure);
  fields.Exchange("degree", structure.Degree, 0, 64);
  fields.Exchange("mode", structure.Mode, ModeWords);
  fields.Exchange("interpolation", structure.Interpolation, InterpolationWords);
  fields.Exchange("smoothing_voxels", structure.Smoothing, 0.0, 8.0);
  if (fields.IsReading() || structure.KeepsCuts)
  {
    fields.Exchange("keeps_cuts", structure.KeepsCuts);
  }
  fields.Exchange("stiffness_n_per_mm", structure.Stiffness, 0.0, ContactLimits::Stiffness);
  fields.Exchange("damping_ns_per_mm", structure.Damping, 0.0, ContactLimits::Damping);
  fields.Exchange("static_friction", structure.Friction.Static, 0.0, ContactLimits::Friction);
  fields.Exchange("dynamic_friction", structure.Friction.Dynamic, 0.0, ContactLimits::Friction);
  ExchangeEffects(fields, structure);
  const DrillLaw& law = structure.Drill;
  if (fields.IsReading() || law.Wear != 0.0 || law.Drag != 0.0 || law.Vibration != 0.0)
  {
    fields.ExchangeObject("drill", structure.Drill, ExchangeDrillLaw);
  }
  fields.Exchange("forbidden", structure.IsForbidden);
  fields.Exchange("alarm_mm", structure.AlarmDistance, 0.0, DrillLimits::Alarm);
}

void ExchangeTool(JsonFields& fields, TouchToolSettings& tool)
{
  fields.Exchange("shape", tool.Kind, ShapeWords);
  fields.Exchange("radius_mm", tool.Radius, 0.0, ContactLimits::ToolRadius);
  fields.Exchange("length_mm", tool.Length, 0.0, LargestLength);
  if (fields.IsReading() || tool.Kind == TouchToolSettings::Shape::Drill)
  {
    fields.Exchange("shaft_radius_mm", tool.ShaftRadius, 0.0, ContactLimits::ToolRadius);
  }
  fields.Exchange("semi_axes_mm", tool.SemiAxes, 0.0, LargestLength);
  fields.ExchangeIfSet("file", tool.File);
  fields.Require(tool.File.empty() != (tool.Kind == TouchToolSettings::Shape::Surface),
                 "has a tool whose shape and file contradict each other",
                 "give a \"file\" for the shape \"surface\", and for no other");
  fields.Exchange("points", tool.Points, 0, ToolShape::MaximumCount);
}

void ExchangeDrillMotion(JsonFields& fields, TouchDrillSettings& drill)
{
  fields.Exchange("turns_per_s", drill.Turns, 0.0, DrillLimits::Turns);
  fields.Exchange("vibration_hz", drill.VibrationFrequency, 0.0, DrillLimits::Vibration);
}

void ExchangeGuide(JsonFields& fields, GuideSettings& guide)
{
  fields.Exchange("shape", guide.Shape, GuideWords);
  if (fields.IsReading() || !guide.HasStructure())
  {
    fields.ExchangeList("points", guide.PointsWorld,
                        [](JsonFields& point, Vector3& place)
                        { point.Exchange("position_mm", place, -LargestPlace, LargestPlace); });
  }
  fields.ExchangeIfSet("structure", guide.Structure, 0, LargestId);
  fields.ExchangeIfSet("distance_mm", guide.Distance, -LargestLength, LargestLength);
  fields.Exchange("stiffness_n_per_mm", guide.Stiffness, 0.0, GuideSettings::MostStiffness);
  fields.Exchange("range_mm", guide.Range, 0.0, LargestLength);
  fields.Exchange("largest_n", guide.LargestForce, 0.0, GuideSettings::MostForce);
  const Status status = CheckGuide(guide);
  fields.Require(status.IsOk(), "cannot use " + fields.Place() + ": " + status.Message(),
                 "correct it there, or remove it from \"guides\"");
}

void ExchangeScale(JsonFields& fields, ScenePlacement& placement)
{
  fields.Exchange("scale", placement.Scale, 1e-3, 1e3);
}

void ExchangePlacement(JsonFields& fields, ScenePlacement& placement)
{
  ExchangeScale(fields, placement);
  fields.Exchange("center_mm", placement.CenterWorld, -LargestPlace, LargestPlace);
  fields.Exchange("axes", placement.AxesFollowCamera, AxesWords);
}
} // namespace

void ExchangeScene(JsonFields& fields, SceneSettings& scene)
{
  fields.Skip(RetiredKeys::Scene);
  scene.Fit.Rules = fields.IsReading() ? 1 : scene.Fit.Rules; // of a scene without "fit"
  fields.Exchange("left_handed", scene.LeftHanded, LeftHandedWords);
  fields.ExchangeList("structures", scene.Structures, ExchangeStructure);
  if (fields.IsReading() || !scene.Guides.empty())
  {
    fields.ExchangeList("guides", scene.Guides, ExchangeGuide);
  }
  fields.ExchangeObject("fit", scene.Fit, ExchangeFitSettings);
  fields.ExchangeObject("tool", scene.Tool, ExchangeTool);
  fields.ExchangeObject("drill", scene.Drill, ExchangeDrillMotion);
  fields.Exchange("device", scene.Device);
  fields.Exchange("rate_hz", scene.Rate, 1.0, 1e5);
  fields.Exchange("model_interval", scene.ModelInterval, 1, 100);
  // Version 0.1.0 had only the scale, next to the rate.
  if (fields.Has("scale"))
  {
    ExchangeScale(fields, scene.Placement);
  }
  fields.ExchangeObject("placement", scene.Placement, ExchangePlacement);
}
} // namespace palpate
