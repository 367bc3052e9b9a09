#include "SessionTargets.h"

#include "BinaryFields.h"
#include "CohortManifest.h"
#include "CohortTable.h"
#include "DrillContextCases.h"
#include "DrillScript.h"
#include "DrillState.h"
#include "HandPath.h"
#include "JsonMutator.h"
#include "Refusal.h"
#include "SceneFile.h"
#include "StudyCases.h"
#include "StudyFile.h"
#include "StudyJson.h"
#include "StudyMarkupsReader.h"
#include "TextMutator.h"

namespace palpate::test
{
namespace
{
constexpr const char* DrillHeadEnd = "]\n";

std::vector<std::string> SceneSeeds()
{
  SceneSettings settings;
  SceneStructure gland;
  gland.Name = "gland";
  gland.File = "/a/gland.json";
  SceneStructure bone;
  bone.File = "/a/ct.nrrd";
  bone.Iso = -300.5;
  bone.Drill.Wear = 0.1;
  SceneStructure mask;
  mask.File = "/a/mask.nii.gz";
  mask.Labels = {"1", "tumour"};
  mask.IsForbidden = true;
  settings.Structures = {gland, bone, mask};
  settings.Placement.Scale = 0.5;
  return {SceneText(settings, "/a")};
}

std::vector<std::string> StudySeeds()
{
  Random random(3);
  std::vector<std::string> seeds;
  for (int i = 0; i < 3; ++i)
  {
    seeds.push_back(StudyText(RandomStudy(random), "/a", "/a/a.palpate.json"));
  }
  return seeds;
}

std::vector<std::string> MarkupsSeeds()
{
  Random random(4);
  std::vector<std::string> seeds;
  for (int i = 0; i < 3; ++i)
  {
    const StudyState state = RandomStudy(random);
    StudyMarkups markups{state.Landmarks, state.Measurements};
    markups.Landmarks.push_back({"apex", Vector3(1.0, 2.0, 3.0)});
    seeds.push_back(WrittenBytes("a.mrk.json", [&](const std::filesystem::path& file)
                                 { WriteMarkups(file, markups); }));
  }
  return seeds;
}

std::string ScriptSeed()
{
  return R"({"format": "palpate-drill", "actions": [
{"time_s": 0.5, "do": "start"},
{"time_s": 1.5, "do": "end-stroke"},
{"time_s": 2, "do": "undo"},
{"time_s": 3, "do": "stop"}]})";
}

std::string HandPathSeed()
{
  return "time_s,x_mm,y_mm,z_mm\n0,1,2,3\n0.5,1.25,-2,3e-1\n1,0,0,0\n";
}

std::string ManifestSeed()
{
  return "case,mask,label,volume\none,masks/1.nii.gz,1,\"volumes/t2, left.nrrd\"\n"
         "two,masks/2.seg.nrrd,\"a \"\"b\"\"\",\n";
}

std::string CohortTableSeed()
{
  CohortRow fitted;
  fitted.Case = "one";
  fitted.Model = "one/model.json";
  fitted.Key = "0123456789abcdef";
  fitted.Result.State = FitResult::Outcome::Fitted;
  fitted.Result.Structure.Label = 1;
  fitted.Result.Model = RadialModel(4, std::vector<double>(25, 0.0), Vector3(1, 2, 3));
  CohortRow refused = fitted;
  refused.Result.State = FitResult::Outcome::Refused;
  refused.Result.Message = "hides 12 %, of its surface";
  return WrittenBytes("cohort.csv",
                      [&](const std::filesystem::path& file)
                      {
                        CohortTable table;
                        table.Add({fitted, refused});
                        table.Write(file);
                      });
}

// Drilled bone; the voxels are always the same, so that drill states fit.
struct DrilledBone
{
  BoneFiles Files;
  std::shared_ptr<DrillContext> Context = BenchOf(Files.Scene());

  void Drill() const
  {
    ContextCuts(this->Context).Cut(Vector3(7.0, 0.0, 0.0), Vector3(7.0, 1.0, 0.0));
  }
};

std::string DrillStateSeed()
{
  const DrilledBone bone;
  bone.Drill();
  return WrittenBytes("a.drill", [&](const std::filesystem::path& file)
                      { WriteDrillState(file, *bone.Context); });
}

std::string RemovalSeed()
{
  const DrilledBone bone;
  bone.Drill();
  const std::vector<std::byte> bytes = StateOf(*bone.Context);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

InputReader DrillStateReader()
{
  const auto bone = std::make_shared<DrilledBone>();
  return FileReader("a.drill", [bone](const std::filesystem::path& file)
                    { ReadDrillState(file, *bone->Context); });
}

// The part of a drill state that mutations of whole files do not reach, because of its digest.
InputReader RemovalReader()
{
  const auto bone = std::make_shared<DrilledBone>();
  return [bone](const std::string& bytes)
  {
    const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
    std::shared_ptr<const RemovedDistances> removed;
    RequireInput(RemovedFromBytes({first, first + bytes.size()},
                                  bone->Context->Editor().Site(0).Now(), removed));
  };
}

// Magic number, 16 numbers of the frame, number of blocks; each block: corner, kind, distances.
Mutator RemovalMutator()
{
  constexpr std::size_t Frame = 4 + 8 * 16;
  std::vector<BinaryField> fields = FieldsFrom(Frame - 8, 3, 8);
  for (const auto& more : {FieldsFrom(0, 1, 4), FieldsFrom(4, 16, 8, BinaryField::Type::Real),
                           FieldsFrom(Frame, 20, 4), FieldsFrom(Frame + 8, 20, 4),
                           FieldsFrom(Frame + 8, 40, 4, BinaryField::Type::Real)})
  {
    fields.insert(fields.end(), more.begin(), more.end());
  }
  return OneOf({FieldMutator(fields), MutateBytes});
}

FuzzTarget FileTarget(const std::string& name, const std::string& fileName,
                      std::vector<std::string> seeds, const Mutator& mutate,
                      void (*read)(const std::filesystem::path&))
{
  return {name, fileName, [all = std::move(seeds)] { return all; },
          OneOf({mutate, mutate, mutate, MutateBytes}),
          [fileName, read] { return FileReader(fileName, read); }};
}

FuzzTarget WithSeed(const std::string& name, const std::string& fileName, std::string (*seed)(),
                    const Mutator& mutate, InputReader (*makeReader)())
{
  return {name, fileName, [seed] { return std::vector<std::string>{seed()}; }, mutate, makeReader};
}

std::vector<FuzzTarget> JsonTargets()
{
  const Mutator scene =
      JsonMutator({"structures",    "tool",           "device",       "name",
                   "file",          "label",          "iso",          "seen",
                   "touched",       "representation", "degree",       "mode",
                   "interpolation", "drill",          "forbidden",    "alarm_mm",
                   "texture_n",     "texture_image",  "scale",        "sphere",
                   "capsule",       "ellipsoid",      "cylinder",     "surface",
                   "points",        "radius_mm",      "semi_axes_mm", "stiffness_to_value"});
  const Mutator study = JsonMutator(
      {"structures", "fit",         "tool",         "landmarks",    "distances", "view",
       "placement",  "field",       "drill",        "crosshair_mm", "window",    "level",
       "center_mm",  "position_mm", "version",      "color",        "volume",    "segmentation",
       "opacity",    "harmonics",   "measurements", "points",       "kind",      "open",
       "thickness",  "facets",      "sub-voxel",    "automatic",    "camera",    "patient"});
  const Mutator markups =
      JsonMutator({"markups", "type", "Fiducial", "Line", "Angle", "Curve", "ClosedCurve", "Plane",
                   "RAS", "um", "normal", "center", "planeType", "controlPoints", "position",
                   "positionStatus", "undefined", "label"});
  const Mutator script =
      JsonMutator({"start", "stop", "end-stroke", "undo", "redo", "reset", "time_s", "do"});
  return {FileTarget("scene", "a.scene.json", SceneSeeds(), scene,
                     [](const std::filesystem::path& file)
                     { SceneText(ReadScene(file), file.parent_path()); }),
          FileTarget("study", "a.palpate.json", StudySeeds(), study,
                     [](const std::filesystem::path& file)
                     { StudyText(ReadStudy(file), file.parent_path(), file); }),
          FileTarget("markups", "a.mrk.json", MarkupsSeeds(), markups,
                     [](const std::filesystem::path& file) { ReadMarkups(file); }),
          FileTarget("drill-script", "a.json", {ScriptSeed()}, script,
                     [](const std::filesystem::path& file) { ReadDrillScript(file); })};
}

std::vector<FuzzTarget> TableTargets()
{
  const Mutator table = TextMutator(
      {{"case", "mask", "label", "volume", "outcome", "fitted", "refused", "bad input", "failed",
        "degree", "10000", "key", "model", "representation", "facets", "harmonics"},
       {{"\"", "\""}},
       ""});
  return {FileTarget("hand-path", "a.csv", {HandPathSeed()}, table,
                     [](const std::filesystem::path& file) { ReadHandPath(file).At(0.3); }),
          FileTarget("cohort-manifest", "a.csv", {ManifestSeed()}, table,
                     [](const std::filesystem::path& file) { ReadManifest(file); }),
          WithSeed("cohort-table", "cohort.csv", CohortTableSeed, OneOf({table, MutateBytes}),
                   []
                   {
                     return FileReader("cohort.csv", [](const std::filesystem::path& file)
                                       { CohortTable::Read(file); });
                   })};
}
} // namespace

std::vector<FuzzTarget> SessionTargets()
{
  std::vector<FuzzTarget> targets = JsonTargets();
  for (FuzzTarget& target : TableTargets())
  {
    targets.push_back(std::move(target));
  }
  const Mutator head =
      TextMutator({{"name", "source", "bytes", "digest"}, {{"[", "]"}}, DrillHeadEnd});
  targets.push_back(WithSeed("drill-state", "a.drill", DrillStateSeed,
                             OneOf({head, head, MutateBytes}), DrillStateReader));
  targets.push_back(
      WithSeed("drill-removal", "a.bin", RemovalSeed, RemovalMutator(), RemovalReader));
  return targets;
}
} // namespace palpate::test
