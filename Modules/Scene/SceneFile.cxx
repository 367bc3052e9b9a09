#include "SceneFile.h"

#include "JsonText.h"
#include "Refusal.h"
#include "SceneEffect.h"
#include "SceneJson.h"
#include "SceneRepresentation.h"
#include "SceneTissue.h"

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestScene = 1 << 26; // bytes; some hundred thousand structures

// Only a linear sub-voxel field can be drilled.
void CheckDrilled(const SceneStructure& structure, const std::filesystem::path& path,
                  const std::string& place)
{
  if (structure.IsForbidden)
  {
    Refuse(path, "declares " + place + " both drilled and forbidden",
           "remove \"drill\" or \"forbidden\"");
  }
  if (!structure.IsTouchable)
  {
    Refuse(path, "declares " + place + " drilled but not touched", "remove \"touched\": false");
  }
  if (!RepresentationOf(structure).CanBeDrilled ||
      structure.Interpolation != FieldInterpolation::Trilinear)
  {
    Refuse(path, "declares " + place + " drilled, which requires a linear sub-voxel field",
           "remove \"representation\" and \"interpolation\" there");
  }
}

// Rejects contradictions in scenes written by hand.
void Check(const SceneStructure& structure, const std::filesystem::path& path, std::size_t number)
{
  const std::string place = "structures[" + std::to_string(number) + "]";
  for (const SceneEffectKind& kind : SceneEffectKinds())
  {
    const bool hasImage = !structure.Image(kind.ImageKey).empty();
    if (!kind.ImageKey.empty() && kind.IsIn(structure) != hasImage)
    {
      Refuse(path, "gives only one entry for the " + kind.Name + " of " + place,
             "give both \"" + kind.Numbers.front().Key + "\" and \"" + kind.ImageKey +
                 "\" (a file)");
    }
  }
  for (const SceneNumber& entry : SurroundingNumbers())
  {
    if (structure.Number(entry.Key) > 0.0 && structure.Source() != SceneSource::Label)
    {
      Refuse(path,
             "gives " + place + ", which is not a label of a segmentation, \"" + entry.Key + "\"",
             "remove it there, or name a segmentation");
    }
  }
  if (structure.Drill.Wear > 0.0)
  {
    CheckDrilled(structure, path, place);
  }
}

nlohmann::json Patched(const nlohmann::json& root, const std::filesystem::path& path,
                       const std::filesystem::path& patch)
{
  constexpr std::uintmax_t LargestPatch = 1 << 20; // bytes
  constexpr std::size_t MostSteps = 100;           // each may copy a part of the scene
  const char* const remedy =
      "write a JSON Patch (RFC 6902) of at most 100 steps that fits the scene";
  const nlohmann::json steps = ReadJson(patch, LargestPatch, remedy);
  try
  {
    if (!steps.is_array() || steps.size() <= MostSteps)
    {
      return root.patch(steps);
    }
  }
  catch (const nlohmann::json::exception&)
  {
    // Its text says nothing to a user.
  }
  Refuse(patch, "cannot be applied to " + path.filename().string(), remedy);
}

void ExchangeFile(JsonFields& fields, SceneSettings& scene)
{
  fields.ExchangeFormat("palpate-scene", "a scene");
  ExchangeScene(fields, scene);
  fields.RefuseOthers();
}
} // namespace

bool IsSceneFile(const std::filesystem::path& path)
{
  const std::string name = path.filename().string();
  const std::string ending = ".scene.json";
  return name == "scene.json" ||
         (name.size() > ending.size() &&
          name.compare(name.size() - ending.size(), ending.size(), ending) == 0);
}

SceneSettings ReadScene(const std::filesystem::path& path, const std::filesystem::path& patch)
{
  nlohmann::json root =
      ReadJson(path, LargestScene, "write a scene as Documentation/HowTo/Touch.md shows");
  if (!patch.empty())
  {
    root = Patched(root, path, patch);
  }
  JsonFields fields(root, path, "scene", path.parent_path());
  SceneSettings scene;
  ExchangeFile(fields, scene);
  if (scene.Structures.empty())
  {
    Refuse(path, "has no structures", "list them: \"structures\": [ { \"file\": ... } ]");
  }
  for (std::size_t s = 0; s < scene.Structures.size(); ++s)
  {
    Check(scene.Structures[s], path, s);
  }
  return scene;
}

std::string SceneText(SceneSettings scene, const std::filesystem::path& folder)
{
  nlohmann::ordered_json root;
  JsonFields fields(root, folder);
  ExchangeFile(fields, scene);
  return root.dump(2) + "\n";
}
} // namespace palpate
