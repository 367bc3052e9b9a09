#include "StudyStructures.h"

#include "FitStructure.h"
#include "SegmentColor.h"
#include "StructureColor.h"
#include "Study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>

namespace palpate
{
namespace
{
SceneStructure StructureOf(const Segment& segment, const std::filesystem::path& file, int degree,
                           bool isShown)
{
  SceneStructure structure;
  structure.Id = segment.Label;
  structure.Name = segment.Name;
  structure.File = file;
  structure.Labels = {std::to_string(segment.Label)};
  structure.Color = StructureColor(segment.Color, segment.Label);
  structure.Representation = TouchRepresentation::ModelOrField;
  structure.Degree = degree;
  structure.IsVisible = isShown;
  structure.IsTouchable = isShown;
  return structure;
}

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
  constexpr double Distinct = 0.2; // of the RGB cube's edge
  constexpr int Candidates = 32;
  std::array<double, 3> best = own;
  double distance = DistanceFromColors(own, state);
  for (int label = 1; distance < Distinct && label <= Candidates; ++label)
  {
    const std::array<double, 3> color = DefaultSegmentColor(label);
    const double found = DistanceFromColors(color, state);
    best = found > distance ? color : best;
    distance = std::max(found, distance);
  }
  return best;
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
  for (const Segment& segment : segmentation.Segments)
  {
    const bool isShown =
        next.Structures.empty() || segmentation.Segments.size() <= Study::MostShownUnasked;
    next.Structures.push_back(
        StructureOf(segment, state.SegmentationFile, state.Fit.Degree, isShown));
  }
  std::copy_if(state.Structures.begin(), state.Structures.end(),
               std::back_inserter(next.Structures),
               [&state](const SceneStructure& one) { return one.File != state.SegmentationFile; });
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
    SceneStructure added = StructureOf(segment, file, state.Fit.Degree, isShown);
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
} // namespace palpate
