#include "StudyStructures.h"

#include "DecimalText.h"
#include "FitStructure.h"
#include "InputError.h"
#include "SceneFile.h"
#include "SceneLabels.h"
#include "SegmentColor.h"
#include "SegmentationFile.h"
#include "StructureColor.h"
#include "Study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>

namespace palpate
{
namespace
{
// The only structure of a file is named after it, unless the file has a name for it.
SceneStructure StructureOf(const Segment& segment, const Segmentation& segmentation,
                           const std::filesystem::path& file, int degree, bool isShown)
{
  const bool isOnly = segmentation.Segments.size() == 1;
  SceneStructure structure;
  structure.Id = segment.Label;
  structure.Name = isOnly && segment.Name.empty() ? CaseNameOf(file) : segment.Name;
  structure.File = file;
  structure.Labels = {std::to_string(segment.Label)};
  structure.Color = StructureColor(segment.Color, segment.Label);
  structure.Representation = TouchRepresentation::ModelOrField;
  structure.Degree = degree;
  structure.IsVisible = isShown;
  structure.IsTouchable = isShown;
  return structure;
}

constexpr double DistinctDistance = 0.2; // of the RGB cube's edge

// The least distance of a colour from those of the state's structures.
double DistanceFromColors(const std::array<double, 3>& color, const StudyState& state)
{
  double least = std::numeric_limits<double>::infinity();
  for (const SceneStructure& one : state.Structures)
  {
    least = std::min(least, std::hypot(color[0] - one.Color[0], color[1] - one.Color[1],
                                       color[2] - one.Color[2]));
  }
  return least;
}

// The colour of an added structure: its own, or if that is hard to tell from one in use, that of
// the default colours which differs most.
std::array<double, 3> DistinctColor(const std::array<double, 3>& own, const StudyState& state)
{
  constexpr int Candidates = 256;
  std::array<double, 3> best = own;
  double distance = DistanceFromColors(own, state);
  for (int label = 1; distance < DistinctDistance && label <= Candidates; ++label)
  {
    const std::array<double, 3> color = DefaultSegmentColor(label);
    const double found = DistanceFromColors(color, state);
    best = found > distance ? color : best;
    distance = std::max(found, distance);
  }
  return best;
}

// Gives structures without colours of their own distinct ones: default colours are chosen by label,
// and labels of several files are often the same.
void GiveDefaultsDistinctColors(StudyState& state)
{
  StudyState before = state;
  before.Structures.clear();
  for (SceneStructure& one : state.Structures)
  {
    const bool isDefault =
        one.Color == SceneStructure().Color || one.Color == DefaultSegmentColor(one.Id);
    one.Color = isDefault ? DistinctColor(one.Color, before) : one.Color;
    before.Structures.push_back(one);
  }
}

// The name of an added structure: its own if its title is unique; otherwise that of its file if it
// has none, with a number where needed.
std::string DistinctName(const SceneStructure& added, const StudyState& state, bool isOnly)
{
  const auto isUsed = [&state](const std::string& title)
  {
    return std::any_of(state.Structures.begin(), state.Structures.end(),
                       [&title](const SceneStructure& one) { return TitleOf(one) == title; });
  };
  if (!isUsed(TitleOf(added)))
  {
    return added.Name;
  }
  const std::string ofFile = CaseNameOf(added.File) + (isOnly ? "" : ", " + TitleOf(added));
  const std::string start = added.Name.empty() ? ofFile : added.Name;
  std::string name = start;
  for (int number = 2; isUsed(name); ++number)
  {
    name = start + " (" + std::to_string(number) + ")";
  }
  return name;
}

// The id of a structure that differs in nothing else; 0 if there is none.
int IdOfSame(const StudyState& state, SceneStructure structure)
{
  const auto found = std::find_if(state.Structures.begin(), state.Structures.end(),
                                  [&structure](const SceneStructure& one)
                                  {
                                    structure.Id = one.Id;
                                    return one == structure;
                                  });
  return found != state.Structures.end() ? found->Id : 0;
}

// The guides of a scene, whose structures have other ids in a study.
std::vector<GuideSettings> Renumbered(std::vector<GuideSettings> guides,
                                      const std::map<int, int>& ids)
{
  for (GuideSettings& guide : guides)
  {
    const auto found = ids.find(guide.Structure);
    guide.Structure = found != ids.end() ? found->second : 0;
  }
  return guides;
}
} // namespace

bool LacksStructures(const StudyState& state)
{
  return std::none_of(state.Structures.begin(), state.Structures.end(),
                      [&state](const SceneStructure& one)
                      { return one.File == state.SegmentationFile; });
}

int NextFreeId(const StudyState& state)
{
  int next = 1'000'000'001; // above every label
  for (const SceneStructure& structure : state.Structures)
  {
    next = std::max(next, structure.Id + 1);
  }
  return next;
}

StudyState WithStructuresOf(const StudyState& state, const Segmentation& segmentation)
{
  StudyState next = state;
  next.Structures.clear();
  StudyState others = state;
  others.Structures.erase(std::remove_if(others.Structures.begin(), others.Structures.end(),
                                         [&state](const SceneStructure& one)
                                         { return one.File == state.SegmentationFile; }),
                          others.Structures.end());
  for (const Segment& segment : segmentation.Segments)
  {
    const bool isShown =
        next.Structures.empty() || segmentation.Segments.size() <= Study::MostShownUnasked;
    next.Structures.push_back(
        StructureOf(segment, segmentation, state.SegmentationFile, state.Fit.Degree, isShown));
    // A file's own colours stay, unless they are in use for other files.
    auto& color = next.Structures.back().Color;
    if (DistanceFromColors(color, others) < DistinctDistance)
    {
      StudyState used = others;
      used.Structures.insert(used.Structures.end(), next.Structures.begin(), next.Structures.end());
      color = DistinctColor(color, used);
    }
  }
  next.Structures.insert(next.Structures.end(), others.Structures.begin(), others.Structures.end());
  DropLooseGuides(next);
  return next;
}

StudyState WithAddedStructuresOf(const StudyState& state, const std::filesystem::path& file,
                                 const Segmentation& segmentation)
{
  StudyState next = state;
  next.SegmentationFile = state.SegmentationFile.empty() ? file : state.SegmentationFile;
  for (const Segment& segment : segmentation.Segments)
  {
    const bool isFirst = &segment == segmentation.Segments.data();
    const bool isShown = isFirst || segmentation.Segments.size() <= Study::MostShownUnasked;
    SceneStructure added = StructureOf(segment, segmentation, file, state.Fit.Degree, isShown);
    const bool isThere = std::any_of(state.Structures.begin(), state.Structures.end(),
                                     [&added](const SceneStructure& one) {
                                       return one.File == added.File && one.Labels == added.Labels;
                                     });
    if (!isThere)
    {
      added.IsTouchable = false;
      added.Color = DistinctColor(added.Color, next);
      added.Name = DistinctName(added, next, segmentation.Segments.size() == 1);
      added.Id = FindStructure(next, added.Id) == nullptr ? added.Id : NextFreeId(next);
      next.Structures.push_back(std::move(added));
    }
  }
  return next;
}

StudyState WithStructure(const StudyState& state, const SceneStructure& structure)
{
  StudyState next = state;
  SceneStructure added = structure;
  const bool isFree = added.Id != 0 && FindStructure(state, added.Id) == nullptr;
  added.Id = isFree ? added.Id : NextFreeId(state);
  added.Color = DistinctColor(added.Color, state);
  added.Name = DistinctName(added, state, true);
  next.Structures.push_back(std::move(added));
  return next;
}

StudyState WithKeptCorrection(const StudyState& state, const std::string& name,
                              const std::filesystem::path& file)
{
  StudyState next = state;
  next.Correction.StructureId = 0;
  next.Correction.Steps.clear();
  for (SceneStructure& start : next.Structures)
  {
    if (start.Id == state.Correction.StructureId)
    {
      SceneStructure kept = start;
      kept.Id = 0;
      kept.Name = name;
      kept.File = StudyPath(file);
      start.IsVisible = false;
      start.IsTouchable = false;
      return WithStructure(next, kept);
    }
  }
  return next;
}

SceneStructure ThresholdStructure(const StudyState& state, const StudyThreshold& threshold)
{
  if (state.VolumeFile.empty())
  {
    throw InputError("there is no volume to take values of; open one first");
  }
  const bool isRange = !threshold.Upper || *threshold.Upper > threshold.Lower;
  if (!std::isfinite(threshold.Lower) || !isRange)
  {
    throw InputError("the upper value must be above the lower one");
  }
  SceneStructure structure;
  structure.File = state.VolumeFile;
  structure.Series = state.DicomSeries;
  if (const StudyVolume* further = FindVolume(state, threshold.VolumeId))
  {
    structure.File = further->File;
    structure.Series = further->Series;
    structure.Move = MoveOf(state, *further);
  }
  structure.Iso = threshold.Lower;
  structure.IsoUpper = threshold.Upper;
  structure.Name = "iso " + SignificantText(threshold.Lower, 6);
  structure.Name += threshold.Upper ? " to " + SignificantText(*threshold.Upper, 6) : "";
  if (threshold.WithinId != 0)
  {
    const SceneStructure* mask = FindStructure(state, threshold.WithinId);
    if (mask == nullptr || mask->Source() != SceneSource::Label || mask->Labels.size() != 1)
    {
      throw InputError("only a label of a segmentation can limit a structure");
    }
    if (mask->Move != structure.Move)
    {
      throw InputError("only a label that is moved as the volume can limit a structure of it");
    }
    structure.WithinFile = mask->File;
    structure.WithinLabel = mask->Labels.front();
    structure.Name += " in " + TitleOf(*mask);
  }
  structure.Name = threshold.Name.empty() ? structure.Name : threshold.Name;
  return structure;
}

SceneSettings ReadWholeScene(const std::filesystem::path& file, LeftHandedAxes leftHanded,
                             const std::filesystem::path& patch)
{
  SceneSettings scene = ResolveLabels(
      ReadScene(file, patch), true,
      [leftHanded](const std::filesystem::path& labels)
      { return std::make_shared<const Segmentation>(ReadSegmentation(labels, leftHanded)); });
  for (SceneStructure& structure : scene.Structures)
  {
    structure.File = StudyPath(structure.File);
    structure.WithinFile = StudyPath(structure.WithinFile);
    structure.Move = {StudyPath(structure.Move.File), StudyPath(structure.Move.Fixed)};
    for (auto& [key, image] : structure.Images)
    {
      image = StudyPath(image);
    }
  }
  return scene;
}

StudyState WithScene(const StudyState& state, const SceneSettings& scene)
{
  StudyState next = state;
  SceneSettings& own = next;
  own = scene;
  if (state.Structures.empty())
  {
    GiveDefaultsDistinctColors(next);
  }
  else
  {
    own.Structures = state.Structures;
    own.Fit = state.Fit;
    own.LeftHanded = state.LeftHanded;
    std::map<int, int> ids; // in the study, by those in the scene
    for (const SceneStructure& added : scene.Structures)
    {
      const int there = IdOfSame(state, added);
      next = there != 0 ? next : WithStructure(next, added);
      ids[added.Id] = there != 0 ? there : next.Structures.back().Id;
    }
    next.Guides = scene.Guides.empty() ? state.Guides : Renumbered(scene.Guides, ids);
  }
  for (const SceneStructure& structure : next.Structures)
  {
    if (structure.Source() == SceneSource::Label && next.SegmentationFile.empty())
    {
      next.SegmentationFile = structure.File;
    }
    if (structure.Source() == SceneSource::IsoValue && next.VolumeFile.empty())
    {
      next.VolumeFile = structure.File;
      next.DicomSeries = structure.Series;
    }
  }
  DropLooseGuides(next);
  return next;
}
} // namespace palpate
