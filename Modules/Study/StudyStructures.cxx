#include "StudyStructures.h"

#include "Study.h"

#include <algorithm>
#include <iterator>

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
  structure.Color = segment.Color;
  structure.Representation = TouchRepresentation::ModelOrField;
  structure.Degree = degree;
  structure.IsVisible = isShown;
  structure.IsTouchable = isShown;
  return structure;
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
      added.Id = FindStructure(next, added.Id) == nullptr ? added.Id : NextFreeId(next);
      next.Structures.push_back(std::move(added));
    }
  }
  return next;
}
} // namespace palpate
