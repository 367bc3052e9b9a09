#include "TouchSceneFile.h"

#include "DrillLimits.h"
#include "JsonFields.h"
#include "JsonText.h"
#include "Refusal.h"
#include "TouchToolJson.h"
#include "TouchWords.h"

#include <algorithm>
#include <iterator>

namespace palpate
{
namespace
{
constexpr const char* Format = "palpate-scene";
constexpr std::uintmax_t LargestFile = 1 << 26; // of some hundred thousand structures
constexpr double LargestStiffness = 1e4;        // N/mm
constexpr double LargestDamping = 10.0;         // N s/mm
constexpr double LargestFriction = 10.0;
constexpr double LargestTexture = 10.0; // N
constexpr double LargestIso = 1e300;

const std::initializer_list<const char*> ModeWords{"nearest", "radial"};

std::string Ordinal(std::size_t number)
{
  return "structures[" + std::to_string(number) + "]";
}

void ReadTexture(JsonFields& fields, const std::filesystem::path& path, std::size_t number,
                 TouchStructureSettings& structure)
{
  std::string image;
  fields.Read("texture_n", structure.Texture, 0.0, LargestTexture);
  fields.Read("texture_image", image);
  if ((structure.Texture > 0.0) != !image.empty())
  {
    Refuse(path, "says only half of the texture of its " + Ordinal(number),
           "give both \"texture_n\", its largest force, and \"texture_image\", a file");
  }
  structure.TextureImage = image.empty() ? std::filesystem::path() : path.parent_path() / image;
}

void ReadBricks(JsonFields& fields, const std::filesystem::path& path, std::size_t number,
                TouchStructureSettings& structure)
{
  int cells = 1 << static_cast<int>(structure.Bricks);
  fields.Read("brick_cells", cells, 4, MostBrickCells);
  const auto* size =
      std::find_if(std::begin(BrickSizes), std::end(BrickSizes),
                   [cells](BrickSize s) { return cells == 1 << static_cast<int>(s); });
  if (size == std::end(BrickSizes))
  {
    Refuse(path, "has bricks of " + std::to_string(cells) + " cells in its " + Ordinal(number),
           "give its \"brick_cells\" as 4, 8 or 16");
  }
  structure.Bricks = *size;
}

// What can be drilled is a whole sub-voxel field, interpolated linearly.
void CheckDrilled(const TouchStructureSettings& structure, const std::filesystem::path& path,
                  std::size_t number)
{
  const std::string place = Ordinal(number);
  if (structure.IsForbidden)
  {
    Refuse(path, "says that its " + place + " is both drilled and forbidden",
           "leave one of \"drill\" and \"forbidden\" out");
  }
  if (!structure.IsTouched)
  {
    Refuse(path, "says that its " + place + " is drilled and not touched",
           "leave \"touched\": false out");
  }
  const TouchRepresentation kind = structure.Representation;
  if ((kind != TouchRepresentation::Automatic && kind != TouchRepresentation::SubVoxel) ||
      structure.Interpolation != FieldInterpolation::Trilinear)
  {
    Refuse(path, "wants its " + place + " drilled, which only a linear sub-voxel field can be",
           "leave \"representation\" and \"interpolation\" out there");
  }
}

void ReadDrill(const nlohmann::json& object, JsonFields& fields, const std::filesystem::path& path,
               std::size_t number, TouchStructureSettings& structure)
{
  if (fields.Has("drill"))
  {
    DrillLaw& law = structure.Drill;
    JsonFields drill(object["drill"], path, Ordinal(number) + ".drill");
    drill.Read("wear_mm_per_nm", law.Wear, 0.0, DrillLimits::Wear);
    drill.Read("drag_s_per_mm", law.Drag, 0.0, DrillLimits::Drag);
    drill.Read("vibration", law.Vibration, 0.0, 1.0);
    drill.RefuseOthers();
  }
  fields.Read("forbidden", structure.IsForbidden);
  if (fields.Has("alarm_mm") && !structure.IsForbidden)
  {
    Refuse(path, "has an alarm for its " + Ordinal(number) + ", which is not forbidden",
           "add \"forbidden\": true there");
  }
  fields.Read("alarm_mm", structure.AlarmDistance, 0.0, DrillLimits::Alarm);
  if (structure.Drill.Wear > 0.0)
  {
    CheckDrilled(structure, path, number);
  }
}

TouchStructureSettings ReadStructure(const nlohmann::json& object,
                                     const std::filesystem::path& path, std::size_t number)
{
  TouchStructureSettings structure;
  JsonFields fields(object, path, "structures[" + std::to_string(number) + "]");
  std::string file;
  fields.Read("name", structure.Name);
  fields.Read("file", file);
  if (file.empty())
  {
    Refuse(path, "cannot be read: its structures[" + std::to_string(number) + "] has no file",
           "name a model, a surface, a segmentation or an image in its entry \"file\"");
  }
  structure.File = path.parent_path() / file;
  fields.Read("label", structure.Labels);
  if (fields.Has("iso"))
  {
    structure.Iso = 0.0;
    fields.Read("iso", *structure.Iso, -LargestIso, LargestIso);
  }
  fields.Read("seen", structure.IsSeen);
  fields.Read("touched", structure.IsTouched);
  fields.ReadChoice("representation", RepresentationWords, structure.Representation);
  fields.Read("degree", structure.Degree, 0, 64);
  fields.ReadChoice("mode", ModeWords, structure.Mode);
  fields.ReadChoice("precision", PrecisionWords, structure.Precision);
  fields.ReadChoice("interpolation", InterpolationWords, structure.Interpolation);
  ReadBricks(fields, path, number, structure);
  fields.Read("smoothing_voxels", structure.Smoothing, 0.0, 8.0);
  fields.Read("stiffness_n_per_mm", structure.Stiffness, 0.0, LargestStiffness);
  fields.Read("damping_ns_per_mm", structure.Damping, 0.0, LargestDamping);
  fields.Read("static_friction", structure.Friction.Static, 0.0, LargestFriction);
  fields.Read("dynamic_friction", structure.Friction.Dynamic, 0.0, LargestFriction);
  fields.Read("viscosity_ns_per_mm", structure.Viscosity, 0.0, LargestDamping);
  ReadTexture(fields, path, number, structure);
  ReadDrill(object, fields, path, number, structure);
  fields.RefuseOthers();
  return structure;
}

nlohmann::ordered_json AsJson(const TouchStructureSettings& structure,
                              const std::filesystem::path& folder)
{
  nlohmann::ordered_json object;
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
  object["seen"] = structure.IsSeen;
  object["touched"] = structure.IsTouched;
  object["representation"] = WordOf(RepresentationWords, structure.Representation);
  object["degree"] = structure.Degree;
  object["mode"] = WordOf(ModeWords, structure.Mode);
  object["precision"] = WordOf(PrecisionWords, structure.Precision);
  object["interpolation"] = WordOf(InterpolationWords, structure.Interpolation);
  object["brick_cells"] = 1 << static_cast<int>(structure.Bricks);
  object["smoothing_voxels"] = structure.Smoothing;
  object["stiffness_n_per_mm"] = structure.Stiffness;
  object["damping_ns_per_mm"] = structure.Damping;
  object["static_friction"] = structure.Friction.Static;
  object["dynamic_friction"] = structure.Friction.Dynamic;
  object["viscosity_ns_per_mm"] = structure.Viscosity;
  if (structure.Texture > 0.0)
  {
    object["texture_n"] = structure.Texture;
    object["texture_image"] = RelativeFile(structure.TextureImage, folder);
  }
  if (structure.Drill.Wear > 0.0)
  {
    object["drill"] = {{"wear_mm_per_nm", structure.Drill.Wear},
                       {"drag_s_per_mm", structure.Drill.Drag},
                       {"vibration", structure.Drill.Vibration}};
  }
  if (structure.IsForbidden)
  {
    object["forbidden"] = true;
    object["alarm_mm"] = structure.AlarmDistance;
  }
  return object;
}
} // namespace

bool IsTouchSceneFile(const std::filesystem::path& path)
{
  const std::string name = path.filename().string();
  const std::string ending = ".scene.json";
  return name == "scene.json" ||
         (name.size() > ending.size() &&
          name.compare(name.size() - ending.size(), ending.size(), ending) == 0);
}

TouchSettings ReadTouchScene(const std::filesystem::path& path)
{
  const nlohmann::json root =
      ReadJson(path, LargestFile, "write a scene as Documentation/HowTo/Touch.md shows");
  JsonFields fields(root, path, "scene");
  std::string format;
  fields.Read("format", format);
  if (format != Format)
  {
    Refuse(path, "does not say that it is a scene to touch",
           "begin it with \"format\": \"" + std::string(Format) + "\"");
  }
  TouchSettings settings;
  if (!fields.Has("structures") || !root["structures"].is_array() || root["structures"].empty())
  {
    Refuse(path, "has nothing to touch", "list its \"structures\": [ { \"file\": ... } ]");
  }
  for (const nlohmann::json& structure : root["structures"])
  {
    settings.Structures.push_back(ReadStructure(structure, path, settings.Structures.size()));
  }
  if (fields.Has("tool"))
  {
    settings.Tool = ReadTouchTool(root["tool"], path);
  }
  if (fields.Has("drill"))
  {
    JsonFields drill(root["drill"], path, "drill");
    drill.Read("turns_per_s", settings.Drill.Turns, 0.0, DrillLimits::Turns);
    drill.Read("vibration_hz", settings.Drill.VibrationFrequency, 0.0, DrillLimits::Vibration);
    drill.RefuseOthers();
  }
  fields.Read("device", settings.Device);
  fields.Read("rate_hz", settings.Rate, 1.0, 1e5);
  fields.Read("model_interval", settings.ModelInterval, 1, 100);
  if (fields.Has("memory_mb"))
  {
    settings.MemoryMegabytes = 1.0;
    fields.Read("memory_mb", *settings.MemoryMegabytes, 1e-3, 1e6);
  }
  if (fields.Has("scale"))
  {
    settings.Scale = 1.0;
    fields.Read("scale", *settings.Scale, 1e-3, 1e3);
  }
  fields.RefuseOthers();
  return settings;
}

std::string TouchSceneText(const TouchSettings& settings, const std::filesystem::path& folder)
{
  nlohmann::ordered_json root;
  root["format"] = Format;
  for (const TouchStructureSettings& structure : settings.Structures)
  {
    root["structures"].push_back(AsJson(structure, folder));
  }
  root["tool"] = TouchToolJson(settings.Tool, folder);
  root["drill"] = {{"turns_per_s", settings.Drill.Turns},
                   {"vibration_hz", settings.Drill.VibrationFrequency}};
  root["device"] = settings.Device;
  root["rate_hz"] = settings.Rate;
  root["model_interval"] = settings.ModelInterval;
  if (settings.MemoryMegabytes)
  {
    root["memory_mb"] = *settings.MemoryMegabytes;
  }
  if (settings.Scale)
  {
    root["scale"] = *settings.Scale;
  }
  return root.dump(2) + "\n";
}
} // namespace palpate
