#include "StructurePairs.h"

#include "CaseText.h"
#include "InputError.h"
#include "Refusal.h"

#include <algorithm>
#include <set>

namespace palpate
{
namespace
{
std::vector<Segment> Chosen(const ComparedFile& file, const std::string& label)
{
  const Segmentation* labels = file.Labels();
  return labels == nullptr || label.empty() ? file.Structures()
                                            : std::vector<Segment>{labels->Find(label)};
}

// Names that are all given and all different.
std::set<std::string> NamesOf(const std::vector<Segment>& segments)
{
  std::set<std::string> names;
  for (const Segment& segment : segments)
  {
    if (segment.Name.empty() || !names.insert(segment.Name).second)
    {
      return {};
    }
  }
  return names;
}

// Numbers are those of a file, or of a folder's order, so names go first where both have them.
bool HaveNamesInCommon(const std::vector<Segment>& first, const std::vector<Segment>& second)
{
  const std::set<std::string> names = NamesOf(first);
  const std::set<std::string> others = NamesOf(second);
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return others.count(name) > 0; });
}

const Segment* PartnerOf(const Segment& structure, const std::vector<Segment>& segments,
                         bool isByName)
{
  const auto found = std::find_if(segments.begin(), segments.end(),
                                  [&](const Segment& segment) {
                                    return isByName ? segment.Name == structure.Name
                                                    : segment.Label == structure.Label;
                                  });
  return found != segments.end() ? &*found : nullptr;
}

std::string Alone(const ComparedFile& file, const Segment& structure, const ComparedFile& other)
{
  return CaseTitle(file.Path(), structure) + " has no partner in " +
         other.Path().filename().string();
}

StructurePairs AllPairs(const ComparedFile& one, const std::vector<Segment>& first,
                        const ComparedFile& other, const std::vector<Segment>& second)
{
  const bool isByName = HaveNamesInCommon(first, second);
  StructurePairs pairs;
  for (const Segment& segment : first)
  {
    if (const Segment* partner = PartnerOf(segment, second, isByName))
    {
      pairs.Pairs.push_back({segment, *partner});
    }
    else
    {
      pairs.Unpaired.push_back(Alone(one, segment, other));
    }
  }
  for (const Segment& segment : second)
  {
    if (PartnerOf(segment, first, isByName) == nullptr)
    {
      pairs.Unpaired.push_back(Alone(other, segment, one));
    }
  }
  return pairs;
}
} // namespace

StructurePairs StructurePairs::Of(const ComparedFile& one, const ComparedFile& other,
                                  const std::string& label, const std::string& otherLabel)
{
  const bool hasLabels = one.Labels() != nullptr || other.Labels() != nullptr;
  if (!hasLabels && !(label.empty() && otherLabel.empty()))
  {
    Refuse(one.Path(), "and " + other.Path().string() + " have no labels",
           "leave out --label and --reference-label, which are for segmentations");
  }
  const std::vector<Segment> first = Chosen(one, label);
  const std::vector<Segment> second = Chosen(other, otherLabel.empty() ? label : otherLabel);
  if (first.size() == 1 && second.size() == 1)
  {
    return {{{first.front(), second.front()}}, {}};
  }
  if (one.Labels() == nullptr || other.Labels() == nullptr)
  {
    const ComparedFile& several = one.Labels() != nullptr ? one : other;
    Refuse(several.Path(), "has several structures, and the other file is one body",
           "choose one with --label");
  }
  StructurePairs pairs = AllPairs(one, first, other, second);
  if (pairs.Pairs.empty())
  {
    Refuse(one.Path(), "and " + other.Path().string() + " have no name and no label in common",
           "choose a structure of each with --label and --reference-label");
  }
  return pairs;
}

Segment OnlyStructure(const ComparedFile& file, const std::string& label, const std::string& advice)
{
  const std::string own = file.Labels() != nullptr ? label : std::string();
  const StructurePairs pairs = StructurePairs::Of(file, file, own, own);
  if (pairs.Pairs.size() != 1)
  {
    Refuse(file.Path(), "has " + std::to_string(pairs.Pairs.size()) + " structures", advice);
  }
  return pairs.Pairs.front().One;
}
} // namespace palpate
