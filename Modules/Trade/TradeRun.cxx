#include "TradeRun.h"

#include "InputError.h"
#include "MachineName.h"
#include "Progress.h"
#include "SceneLabels.h"

#include <algorithm>
#include <set>
#include <utility>

namespace palpate
{
namespace
{
SegmentationReader ReaderOf(SceneRun& files, const SceneSettings& scene,
                            const ProgressFunction& progress)
{
  return [&files, leftHanded = scene.LeftHanded, &progress](const std::filesystem::path& file)
  { return files.SegmentationOf(file, leftHanded, progress); };
}

// The scene with one label for each structure that is touched; the others may be parts of these.
SceneSettings Resolve(SceneSettings scene, SceneRun& files, const ProgressFunction& progress)
{
  for (SceneStructure& structure : scene.Structures)
  {
    structure.IsVisible = structure.IsForbidden = false;
  }
  return ResolveLabels(scene, false, ReaderOf(files, scene, progress));
}

bool IsSame(const SceneStructure& a, const SceneStructure& b)
{
  return a.IsTouchable && b.IsTouchable && a.Name == b.Name && a.File == b.File &&
         a.Labels == b.Labels && a.Iso == b.Iso && a.IsLimited() == b.IsLimited();
}

// A structure with an advised setting, which was made without display and drilling.
SceneStructure WithAdvice(const SceneStructure& structure, const SceneStructure& advised)
{
  SceneStructure changed = advised;
  changed.Id = structure.Id;
  changed.IsVisible = structure.IsVisible;
  changed.IsForbidden = structure.IsForbidden;
  return changed;
}

// The scene, resolved, with the advice on each measured structure.
SceneSettings AdvisedScene(SceneSettings scene, const TradeResult& result)
{
  int points = 0;
  for (const TradeStructureResult& measured : result.Structures)
  {
    if (!measured.Advice.Row)
    {
      continue;
    }
    const ContactSetting& setting = measured.Rows[*measured.Advice.Row].Setting;
    points = setting.Structure.Representation == TouchRepresentation::SubVoxel
                 ? std::max(points, setting.ToolPoints)
                 : points;
    for (SceneStructure& structure : scene.Structures)
    {
      structure = IsSame(structure, setting.Structure) ? WithAdvice(structure, setting.Structure)
                                                       : structure;
    }
  }
  scene.Tool.Points = points > 0 ? points : scene.Tool.Points;
  return scene;
}

// The structures to measure: touchable, one label each.
std::vector<SceneStructure> TouchedOf(const SceneSettings& resolved)
{
  std::vector<SceneStructure> all = resolved.Structures;
  all.erase(std::remove_if(all.begin(), all.end(),
                           [](const SceneStructure& structure) { return !structure.IsTouchable; }),
            all.end());
  if (all.empty())
  {
    throw InputError("no structure of the scene is touchable, so there is nothing to measure; "
                     "set \"touched\": true for a structure");
  }
  return all;
}

// Those selected by name.
std::vector<SceneStructure> Choose(const std::vector<std::string>& names,
                                   std::vector<SceneStructure> structures)
{
  std::set<std::string> known;
  std::string list;
  for (const SceneStructure& structure : structures)
  {
    const std::string title = TitleOf(structure);
    list += known.insert(title).second ? (list.empty() ? "" : ", ") + title : std::string();
  }
  for (const std::string& name : names)
  {
    if (known.count(name) == 0)
    {
      throw InputError("--structure " + name + " is not touched in the scene; name one of " + list);
    }
  }
  if (!names.empty())
  {
    const auto isLeftOut = [&names](const SceneStructure& structure)
    { return std::find(names.begin(), names.end(), TitleOf(structure)) == names.end(); };
    structures.erase(std::remove_if(structures.begin(), structures.end(), isLeftOut),
                     structures.end());
  }
  return structures;
}
} // namespace

TradeResult RunTrade(const TradeRunSettings& settings, const Clock& clock,
                     const ProgressFunction& progress)
{
  constexpr double Preparing = 0.05; // fraction of a structure's time, roughly
  TradeResult result{{}, MachineName(), settings, {}};
  SceneRun files;
  const SceneSettings whole =
      ResolveLabels(settings.Scene, false, ReaderOf(files, settings.Scene, progress));
  const SceneSettings scene = Resolve(settings.Scene, files, progress);
  const std::vector<SceneStructure> structures = Choose(settings.Structures, TouchedOf(scene));
  const auto count = static_cast<double>(structures.size());
  for (const SceneStructure& structure : structures)
  {
    const std::string name = TitleOf(structure);
    const auto done = static_cast<double>(result.Structures.size());
    StructureTrade trade(scene, structure, files, settings.Measurement, clock);
    const std::vector<ContactSetting> candidates =
        trade.Candidates([&](double part, const std::string& stage)
                         { return progress((done + Preparing * part) / count, stage); });
    TradeStructureResult measured{
        name,
        trade.MeasureAll(candidates,
                         [&](double part, const std::string& setting)
                         {
                           const double ready = Preparing + (1.0 - Preparing) * part;
                           return progress((done + ready) / count, name + ", " + setting);
                         }),
        {}};
    measured.Advice = AdviseOn(measured.Rows, scene.Rate);
    result.Structures.push_back(std::move(measured));
  }
  result.Advised = AdvisedScene(whole, result);
  return result;
}
} // namespace palpate
