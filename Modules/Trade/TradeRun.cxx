#include "TradeRun.h"

#include "FilterRun.h"
#include "InputError.h"
#include "MachineName.h"
#include "SceneLabels.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// The structures to measure: touchable, one label each.
std::vector<SceneStructure> TouchedOf(const SceneSettings& scene, SceneRun& files,
                                      const ProgressFunction& progress)
{
  SceneSettings touched = scene;
  for (SceneStructure& structure : touched.Structures)
  {
    structure.IsVisible = structure.IsForbidden = false;
  }
  touched = ResolveLabels(touched, false,
                          [&](const std::filesystem::path& file)
                          { return files.SegmentationOf(file, scene.LeftHanded, progress); });
  std::vector<SceneStructure>& all = touched.Structures;
  all.erase(std::remove_if(all.begin(), all.end(),
                           [](const SceneStructure& structure) { return !structure.IsTouchable; }),
            all.end());
  if (all.empty())
  {
    throw InputError("no structure of the scene is touchable, so there is nothing to measure; "
                     "set \"touched\": true for a structure");
  }
  return std::move(all);
}

// Those selected by name.
std::vector<SceneStructure> Choose(const std::vector<std::string>& names,
                                   std::vector<SceneStructure> structures)
{
  std::string known;
  for (const SceneStructure& structure : structures)
  {
    known += (known.empty() ? "" : ", ") + TitleOf(structure);
  }
  std::vector<SceneStructure> chosen;
  for (const std::string& name : names)
  {
    const auto found = std::find_if(structures.begin(), structures.end(),
                                    [&name](const SceneStructure& structure)
                                    { return TitleOf(structure) == name; });
    if (found == structures.end())
    {
      throw InputError("--structure " + name + " is not touchable in the scene; name one of " +
                       known);
    }
    chosen.push_back(*found);
  }
  return names.empty() ? structures : chosen;
}
} // namespace

TradeResult RunTrade(const TradeRunSettings& settings, const Clock& clock,
                     const ProgressFunction& progress)
{
  constexpr double Preparing = 0.05; // fraction of a structure's time, roughly
  TradeResult result{{}, MachineName(), settings};
  SceneRun files(true);
  const std::vector<SceneStructure> structures =
      Choose(settings.Structures, TouchedOf(settings.Scene, files, progress));
  const auto count = static_cast<double>(structures.size());
  for (const SceneStructure& structure : structures)
  {
    const std::string name = TitleOf(structure);
    const auto done = static_cast<double>(result.Structures.size());
    StructureTrade trade(settings.Scene, structure, files, settings.Measurement, clock);
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
    measured.Advice = AdviseOn(measured.Rows, settings.Scene.Rate);
    result.Structures.push_back(std::move(measured));
  }
  return result;
}
} // namespace palpate
