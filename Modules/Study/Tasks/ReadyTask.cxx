#include "ReadyTask.h"

#include "ImageWriter.h"
#include "ModelFile.h"
#include "PhantomSampler.h"
#include "PoseMap.h"
#include "ProstateLikeModel.h"
#include "SoftwareVersions.h"
#include "TaskFile.h"
#include "TransformFile.h"
#include "Units.h"
#include "WholeFile.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
using JsonObject = nlohmann::ordered_json;

constexpr int BodyDegree = 8;
constexpr int StartDegree = 3; // of a mask that lacks the body's details
constexpr const char* SceneName = "gland.scene.json";

// Diameter and depth (mm) of nodules, and where they lie beside the middle of the posterior side,
// parts of the radius. The last target has none.
struct HiddenNodule
{
  double Diameter;
  double Depth;
  double Left;
  double Up;
};
constexpr std::array<HiddenNodule, 4> Nodules{
    {{12.0, 2.0, 0.25, 0.2}, {10.0, 2.0, -0.3, 0.1}, {8.0, 2.0, 0.1, -0.3}, {0.0, 0.0, 0.0, 0.0}}};
constexpr HiddenNodule TrainingNodule{14.0, 2.0, -0.15, -0.15};

// One target's folder and body.
struct Phantom
{
  std::filesystem::path Folder;
  RadialModel Body;
};

PhantomGrid TaskGrid(const RadialModel& body)
{
  PhantomGrid grid;
  constexpr double Margin = 6.0; // mm
  const int size = static_cast<int>(std::ceil(2.0 * (PhantomSampler::RadiusBound(body) + Margin)));
  grid.Spacing = Vector3::Ones();
  grid.Size = {{size, size, size}};
  grid.CenterOn(body.CenterWorld());
  return grid;
}

PhantomImages MasksOf(const RadialModel& body, const PhantomGrid& grid,
                      const std::optional<PhantomNodule>& nodule)
{
  PhantomAppearance look;
  look.Subdivision = 1;
  look.Nodule = nodule;
  return MakePhantom(body, grid, look);
}

void WriteScene(const std::filesystem::path& folder, const JsonObject& structures,
                double toolRadius)
{
  const JsonObject scene{{"format", "palpate-scene"},
                         {"structures", structures},
                         {"tool", {{"shape", "sphere"}, {"radius_mm", toolRadius}}},
                         {"placement", {{"scale", 1}}}};
  WriteWholeFile(folder / SceneName, scene.dump(2) + "\n");
}

void WriteGland(const Phantom& phantom)
{
  ModelProvenance provenance;
  provenance.Program = "palpate " + SoftwareVersions().front().second;
  WriteModel(phantom.Folder / "gland.json", {phantom.Body, provenance});
}

void WriteRigidScene(const Phantom& phantom)
{
  WriteGland(phantom);
  WriteScene(phantom.Folder, {{{"file", "gland.json"}, {"stiffness_n_per_mm", 1.0}}}, 1.0);
}

Vector3 DirectionTo(double left, double posterior, double up)
{
  return Vector3(left, posterior, up).normalized();
}

void WriteNodule(const Phantom& phantom, const HiddenNodule& hidden, TaskTarget& target)
{
  const RadialModel& body = phantom.Body;
  std::optional<PhantomNodule> nodule;
  JsonObject structures{{{"file", "mask.nii.gz"},
                         {"label", 1},
                         {"representation", "elastic"},
                         {"modulus_kpa", 20},
                         {"free_side", "posterior"},
                         {"elements_across", 12}}};
  if (hidden.Diameter > 0.0)
  {
    const Vector3 direction = DirectionTo(hidden.Left, 1.0, hidden.Up);
    const double radius = 0.5 * hidden.Diameter;
    const Vector3 above = body.PointWorld(direction);
    const Vector3 center = above - (hidden.Depth + radius) * body.Normal(direction);
    nodule = PhantomNodule{center - body.CenterWorld(), radius};
    target.Points = {{"", above}};
    target.Diameter = hidden.Diameter;
    structures.push_back(
        {{"file", "nodule.nii.gz"}, {"label", 1}, {"touched", false}, {"inclusion_kpa", 80}});
  }
  target.Tolerance = 10.0;
  const PhantomImages masks = MasksOf(body, TaskGrid(body), nodule);
  WriteImage(phantom.Folder / "mask.nii.gz", masks.Mask);
  if (masks.Nodule)
  {
    WriteImage(phantom.Folder / "nodule.nii.gz", masks.Nodule);
  }
  WriteScene(phantom.Folder, structures, 8.0);
}

void WriteLandmarks(const Phantom& phantom, TaskTarget& target)
{
  const std::array<std::pair<const char*, Vector3>, 10> places{{{"base", {0, 0, 1}},
                                                                {"apex", {0, 0, -1}},
                                                                {"left", {1, 0, 0}},
                                                                {"right", {-1, 0, 0}},
                                                                {"anterior", {0, -1, 0}},
                                                                {"posterior", {0, 1, 0}},
                                                                {"left base", {1, 0.5, 1}},
                                                                {"right base", {-1, 0.5, 1}},
                                                                {"left apex", {1, 0.5, -1}},
                                                                {"right apex", {-1, 0.5, -1}}}};
  for (const auto& [name, direction] : places)
  {
    target.Points.push_back({name, phantom.Body.PointWorld(direction.normalized())});
  }
  target.Tolerance = 2.0;
  WriteRigidScene(phantom);
}

// Points in the axial plane through the centre, `outside` mm (along the radius) off the surface.
void AddRing(const RadialModel& body, double outside, int count, double turns, TaskTarget& target)
{
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * turns * i / count;
    const Vector3 direction(std::cos(angle), std::sin(angle), 0.0);
    target.Points.push_back({"", body.PointWorld(direction) + outside * direction});
  }
}

void WriteMask(const Phantom& phantom, TaskTarget& target)
{
  const PhantomGrid grid = TaskGrid(phantom.Body);
  const RadialModel start = phantom.Body.WithDegree(StartDegree);
  const PhantomImages images = MasksOf(phantom.Body, grid, {});
  WriteImage(phantom.Folder / "true.nii.gz", images.Mask);
  WriteImage(phantom.Folder / "image.nii.gz", images.Volume);
  WriteImage(phantom.Folder / "start.nii.gz", MasksOf(start, grid, {}).Mask);
  WriteScene(phantom.Folder, {{{"file", "start.nii.gz"}, {"label", 1}}}, 1.0);
  target.Mask = phantom.Folder / "true.nii.gz";
  target.Image = phantom.Folder / "image.nii.gz";
}

void WriteDock(const Phantom& phantom, TaskTarget& target)
{
  target.Points = {{"", phantom.Body.CenterWorld()}};
  target.Pose = {Vector3(8.0, -5.0, 3.0), Vector3(0.0, 0.0, 10.0)};
  WriteGland(phantom);
  WriteTransform(phantom.Folder / "place.tfm",
                 MapOf(target.Pose, target.Points.front().PointWorld));
  // Through the place the body is seen.
  WriteScene(phantom.Folder,
             {{{"name", "body"}, {"file", "gland.json"}},
              {{"name", "place"},
               {"file", "gland.json"},
               {"transform", "place.tfm"},
               {"touched", false},
               {"opacity", 0.5}}},
             1.0);
}

// How the target of a kind is made; `number` counts from 0, training last.
void WriteTarget(TaskKind kind, const Phantom& phantom, std::size_t number, TaskTarget& target)
{
  switch (kind)
  {
  case TaskKind::Nodule:
    return WriteNodule(phantom, target.IsTraining ? TrainingNodule : Nodules.at(number), target);
  case TaskKind::Landmarks:
    return WriteLandmarks(phantom, target);
  case TaskKind::Outline:
    AddRing(phantom.Body, 0.0, 72, 1.0, target);
    return WriteRigidScene(phantom);
  case TaskKind::Path:
    // A tool of 1 mm has 1 mm to the surface.
    AddRing(phantom.Body, 2.0, 54, 0.75, target);
    target.Tolerance = 4.0;
    return WriteRigidScene(phantom);
  case TaskKind::Mask:
    return WriteMask(phantom, target);
  case TaskKind::Dock:
    return WriteDock(phantom, target);
  }
}

struct Wording
{
  const char* Title;
  const char* Instructions;
  double MostSeconds;
};

Wording WordingOf(TaskKind kind)
{
  const std::array<Wording, 6> wordings{
      {{"Find and size a nodule",
        "Palpate the posterior side of the organ. If a place is harder, mark it and say how large "
        "it is; some organs have no nodule.",
        300.0},
       {"Mark ten landmarks", "Mark each displayed landmark on the organ's surface.", 180.0},
       {"Outline a gland", "Draw the outline of the gland in the displayed slice.", 120.0},
       {"Correct a mask",
        "Push and pull the surface until it lies on the edge of the organ in the slices.", 600.0},
       {"Dock two bodies", "Move and turn the body until it lies exactly where the other one is.",
        300.0},
       {"Follow a path",
        "Follow the displayed path from its start to its end without touching "
        "the organ.",
        120.0}}};
  return wordings.at(static_cast<std::size_t>(kind));
}

TaskSettings TaskOfKind(TaskKind kind, std::uint64_t seed)
{
  const Wording wording = WordingOf(kind);
  TaskSettings task;
  task.Id = NameOf(kind);
  task.Title = wording.Title;
  task.Kind = kind;
  task.Instructions = wording.Instructions;
  task.Conditions = {{"force", true, {}}, {"no-force", false, {}}};
  task.Questions = {{"hand", "Which hand do you use?", {"left", "right"}, 0.0, 0.0},
                    {"years", "Years of experience", {}, 0.0, 60.0}};
  task.Trials = kind == TaskKind::Nodule ? 4 : 3;
  task.TrainingTrials = 1;
  task.MostSeconds = wording.MostSeconds;
  task.MostForce = 6.0;
  task.PauseAfter = task.Trials + task.TrainingTrials;
  task.PauseSeconds = 60.0;
  task.Seed = static_cast<int>(seed);
  return task;
}
} // namespace

std::string ReadyTaskTitle(TaskKind kind)
{
  return WordingOf(kind).Title;
}

void WriteReadyTask(TaskKind kind, std::uint64_t seed, const std::filesystem::path& folder,
                    const ProgressFunction& progress)
{
  TaskSettings task = TaskOfKind(kind, seed);
  const std::size_t count = kind == TaskKind::Nodule ? Nodules.size() : 3;
  for (std::size_t i = 0; i <= count; ++i)
  {
    ReportProgress(progress, static_cast<double>(i) / static_cast<double>(count + 1), "phantoms");
    TaskTarget target;
    target.IsTraining = i == count;
    target.Id = target.IsTraining ? "training" : "target-" + std::to_string(i + 1);
    Phantom phantom{folder / target.Id,
                    MakeProstateLikeModel(BodyDegree, seed + i, Vector3::Zero())};
    std::filesystem::create_directories(phantom.Folder);
    target.Scene = phantom.Folder / SceneName;
    WriteTarget(kind, phantom, i, target);
    task.Targets.push_back(std::move(target));
  }
  WriteWholeFile(folder / "task.json", TaskText(task, folder));
}
} // namespace palpate
