#include "SceneJson.h"

#include "DrillLimits.h"
#include "FitSettingsJson.h"
#include "Refusal.h"
#include "RetiredKeys.h"
#include "SceneEffect.h"
#include "SceneRepresentation.h"
#include "SceneToolJson.h"

namespace palpate
{
namespace
{
using OrderedJson = nlohmann::ordered_json;

constexpr double LargestPlace = 1e6;     // mm, of coordinates
constexpr double LargestStiffness = 1e4; // N/mm
constexpr double LargestDamping = 10.0;  // N s/mm
constexpr double LargestFriction = 10.0;
constexpr double LargestIso = 1e300;
constexpr int LargestId = 2'000'000'000;

const std::initializer_list<const char*> InterpolationWords{"linear", "cubic"};
const std::initializer_list<const char*> ModeWords{"nearest", "radial"};
const std::initializer_list<const char*> LeftHandedWords{"refuse", "reverse"};
const std::initializer_list<const char*> AppearanceWords{"automatic", "model", "surface",
                                                         "error-map", "sub-voxel"};
const std::initializer_list<const char*> AxesWords{"patient", "camera"};

class SceneReader
{
public:
  SceneReader(const nlohmann::json& object, const std::filesystem::path& folder,
              const std::filesystem::path& file)
      : Object(object), Folder(folder), File(file)
  {
  }

  SceneSettings Read(JsonFields& fields) const
  {
    SceneSettings scene;
    fields.Skip(RetiredKeys::Scene);
    fields.Exchange("left_handed", scene.LeftHanded, LeftHandedWords);
    if (fields.Has("structures"))
    {
      this->ReadStructures(scene);
    }
    fields.ExchangeObject("fit", scene.Fit, ExchangeFitSettings);
    if (fields.Has("tool"))
    {
      scene.Tool = ReadSceneTool(this->Object["tool"], this->Folder, this->File);
    }
    if (fields.Has("drill"))
    {
      JsonFields drill(this->Object["drill"], this->File, "drill");
      drill.Exchange("turns_per_s", scene.Drill.Turns, 0.0, DrillLimits::Turns);
      drill.Exchange("vibration_hz", scene.Drill.VibrationFrequency, 0.0, DrillLimits::Vibration);
      drill.RefuseOthers();
    }
    fields.Exchange("device", scene.Device);
    fields.Exchange("rate_hz", scene.Rate, 1.0, 1e5);
    fields.Exchange("model_interval", scene.ModelInterval, 1, 100);
    this->ReadPlacement(fields, scene.Placement);
    return scene;
  }

private:
  std::filesystem::path PathOf(const std::string& text) const
  {
    return text.empty() ? std::filesystem::path()
                        : (this->Folder / std::filesystem::u8path(text)).lexically_normal();
  }

  void ReadStructures(SceneSettings& scene) const
  {
    const nlohmann::json& list = this->Object["structures"];
    if (!list.is_array())
    {
      Refuse(this->File, "cannot be read: its \"structures\" is not a list",
             "write them as [ { \"file\": ... } ]");
    }
    for (const nlohmann::json& object : list)
    {
      scene.Structures.push_back(this->ReadStructure(object, scene.Structures.size()));
    }
  }

  SceneStructure ReadStructure(const nlohmann::json& object, std::size_t number) const
  {
    const std::string place = "structures[" + std::to_string(number) + "]";
    SceneStructure structure;
    JsonFields fields(object, this->File, place);
    fields.Skip(RetiredKeys::SceneStructure);
    fields.Exchange("id", structure.Id, 0, LargestId);
    fields.Exchange("name", structure.Name);
    std::string file;
    fields.Exchange("file", file);
    if (file.empty())
    {
      Refuse(this->File, "cannot be read: " + place + " has no file",
             "name a model, a surface, a segmentation or an image in its entry \"file\"");
    }
    structure.File = this->PathOf(file);
    fields.Exchange("label", structure.Labels);
    if (fields.Has("iso"))
    {
      structure.Iso = 0.0;
      fields.Exchange("iso", *structure.Iso, -LargestIso, LargestIso);
    }
    this->ReadDisplay(fields, structure);
    this->ReadTouch(fields, structure);
    this->ReadDrill(object, fields, place, structure);
    fields.RefuseOthers();
    return structure;
  }

  void ReadDisplay(JsonFields& fields, SceneStructure& structure) const
  {
    fields.Exchange("seen", structure.IsVisible);
    Vector3 color(structure.Color[0], structure.Color[1], structure.Color[2]);
    fields.Exchange("color", color, 0.0, 1.0);
    structure.Color = {{color[0], color[1], color[2]}};
    fields.Exchange("shown_as", structure.Appearance, AppearanceWords);
  }

  void ReadTouch(JsonFields& fields, SceneStructure& structure) const
  {
    fields.Exchange("touched", structure.IsTouchable);
    ReadRepresentation(fields, structure);
    fields.Exchange("degree", structure.Degree, 0, 64);
    fields.Exchange("mode", structure.Mode, ModeWords);
    fields.Exchange("interpolation", structure.Interpolation, InterpolationWords);
    fields.Exchange("smoothing_voxels", structure.Smoothing, 0.0, 8.0);
    fields.Exchange("stiffness_n_per_mm", structure.Stiffness, 0.0, LargestStiffness);
    fields.Exchange("damping_ns_per_mm", structure.Damping, 0.0, LargestDamping);
    fields.Exchange("static_friction", structure.Friction.Static, 0.0, LargestFriction);
    fields.Exchange("dynamic_friction", structure.Friction.Dynamic, 0.0, LargestFriction);
    for (const SceneEffectKind& kind : SceneEffectKinds())
    {
      this->ReadEffect(fields, kind, structure);
    }
  }

  static void ReadRepresentation(JsonFields& fields, SceneStructure& structure)
  {
    std::vector<std::string> names;
    for (const SceneRepresentation& representation : SceneRepresentations())
    {
      names.push_back(representation.Name);
      ReadNumbers(fields, representation.Numbers, structure);
    }
    fields.Exchange("representation", structure.Representation, names);
  }

  static void ReadNumbers(JsonFields& fields, const std::vector<SceneNumber>& numbers,
                          SceneStructure& structure)
  {
    for (const SceneNumber& number : numbers)
    {
      double value = 0.0;
      fields.Exchange(number.Key.c_str(), value, 0.0, number.Largest);
      structure.SetNumber(number.Key, value);
    }
  }

  void ReadEffect(JsonFields& fields, const SceneEffectKind& kind, SceneStructure& structure) const
  {
    ReadNumbers(fields, kind.Numbers, structure);
    if (!kind.ImageKey.empty())
    {
      std::string image;
      fields.Exchange(kind.ImageKey.c_str(), image);
      structure.SetImage(kind.ImageKey, this->PathOf(image));
    }
  }

  void ReadDrill(const nlohmann::json& object, JsonFields& fields, const std::string& place,
                 SceneStructure& structure) const
  {
    if (fields.Has("drill"))
    {
      DrillLaw& law = structure.Drill;
      JsonFields drill(object["drill"], this->File, place + ".drill");
      drill.Exchange("wear_mm_per_nm", law.Wear, 0.0, DrillLimits::Wear);
      drill.Exchange("drag_s_per_mm", law.Drag, 0.0, DrillLimits::Drag);
      drill.Exchange("vibration", law.Vibration, 0.0, 1.0);
      drill.RefuseOthers();
    }
    fields.Exchange("forbidden", structure.IsForbidden);
    fields.Exchange("alarm_mm", structure.AlarmDistance, 0.0, DrillLimits::Alarm);
  }

  // Version 0.1.0 had only the scale, next to the rate.
  void ReadPlacement(JsonFields& fields, ScenePlacement& placement) const
  {
    ReadScale(fields, placement);
    if (fields.Has("placement"))
    {
      JsonFields place(this->Object["placement"], this->File, "placement");
      ReadScale(place, placement);
      if (place.Has("center_mm"))
      {
        Vector3 center = Vector3::Zero();
        place.Exchange("center_mm", center, -LargestPlace, LargestPlace);
        placement.CenterWorld = center;
      }
      place.Exchange("axes", placement.AxesFollowCamera, AxesWords);
      place.RefuseOthers();
    }
  }

  static void ReadScale(JsonFields& fields, ScenePlacement& placement)
  {
    if (fields.Has("scale"))
    {
      placement.Scale = 1.0;
      fields.Exchange("scale", *placement.Scale, 1e-3, 1e3);
    }
  }

  const nlohmann::json& Object;
  const std::filesystem::path& Folder;
  const std::filesystem::path& File;
};

bool IsOtherDrill(const DrillLaw& law)
{
  const DrillLaw none;
  return law.Wear != none.Wear || law.Drag != none.Drag || law.Vibration != none.Vibration;
}

OrderedJson AsJson(const SceneStructure& structure, const std::filesystem::path& folder)
{
  OrderedJson object;
  if (structure.Id != 0)
  {
    object["id"] = structure.Id;
  }
  if (!structure.Name.empty())
  {
    object["name"] = structure.Name;
  }
  object["file"] = RelativeFile(structure.File, folder);
  if (!structure.Labels.empty())
  {
    object["label"] = structure.Labels;
  }
  if (structure.Iso)
  {
    object["iso"] = *structure.Iso;
  }
  object["seen"] = structure.IsVisible;
  object["color"] = structure.Color;
  object["shown_as"] = WordOf(AppearanceWords, structure.Appearance);
  object["touched"] = structure.IsTouchable;
  object["representation"] = structure.Representation;
  object["degree"] = structure.Degree;
  object["mode"] = WordOf(ModeWords, structure.Mode);
  object["interpolation"] = WordOf(InterpolationWords, structure.Interpolation);
  object["smoothing_voxels"] = structure.Smoothing;
  object["stiffness_n_per_mm"] = structure.Stiffness;
  object["damping_ns_per_mm"] = structure.Damping;
  object["static_friction"] = structure.Friction.Static;
  object["dynamic_friction"] = structure.Friction.Dynamic;
  for (const auto& [key, number] : structure.Numbers)
  {
    object[key] = number;
  }
  for (const auto& [key, image] : structure.Images)
  {
    object[key] = RelativeFile(image, folder);
  }
  if (IsOtherDrill(structure.Drill))
  {
    object["drill"] = {{"wear_mm_per_nm", structure.Drill.Wear},
                       {"drag_s_per_mm", structure.Drill.Drag},
                       {"vibration", structure.Drill.Vibration}};
  }
  object["forbidden"] = structure.IsForbidden;
  object["alarm_mm"] = structure.AlarmDistance;
  return object;
}

OrderedJson AsJson(const ScenePlacement& placement)
{
  OrderedJson object = OrderedJson::object();
  if (placement.Scale)
  {
    object["scale"] = *placement.Scale;
  }
  if (placement.CenterWorld)
  {
    const Vector3& center = *placement.CenterWorld;
    object["center_mm"] = {center[0], center[1], center[2]};
  }
  object["axes"] = WordOf(AxesWords, placement.AxesFollowCamera);
  return object;
}
} // namespace

SceneSettings ReadSceneJson(const nlohmann::json& object, JsonFields& fields,
                            const std::filesystem::path& folder, const std::filesystem::path& file)
{
  return SceneReader(object, folder, file).Read(fields);
}

void AddSceneJson(OrderedJson& object, const SceneSettings& scene,
                  const std::filesystem::path& folder)
{
  object["left_handed"] = WordOf(LeftHandedWords, scene.LeftHanded);
  object["structures"] = OrderedJson::array();
  for (const SceneStructure& structure : scene.Structures)
  {
    object["structures"].push_back(AsJson(structure, folder));
  }
  object["fit"] = FitSettingsJson(scene.Fit);
  object["tool"] = SceneToolJson(scene.Tool, folder);
  object["drill"] = {{"turns_per_s", scene.Drill.Turns},
                     {"vibration_hz", scene.Drill.VibrationFrequency}};
  object["device"] = scene.Device;
  object["rate_hz"] = scene.Rate;
  object["model_interval"] = scene.ModelInterval;
  object["placement"] = AsJson(scene.Placement);
}
} // namespace palpate
