#include "StructurePairs.h"

#include "CaseText.h"
#include "InputError.h"
#include "Refusal.h"

#include <algorithm>

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

const Segment* WithLabel(const std::vector<Segment>& segments, int label)
{
  const auto found =
      std::find_if(segments.begin(), segments.end(),
                   [label](const Segment& segment) { return segment.Label == label; });
  return found != segments.end() ? &*found : nullptr;
}

std::string Alone(const ComparedFile& file, const Segment& structure, const ComparedFile& other)
{
  return CaseTitle(file.Path(), structure) + " has no partner in " +
         other.Path().filename().string();
}

StructurePairs ByLabel(const ComparedFile& one, const std::vector<Segment>& first,
                       const ComparedFile& other, const std::vector<Segment>& second)
{
  StructurePairs pairs;
  for (const Segment& segment : first)
  {
    if (const Segment* partner = WithLabel(second, segment.Label))
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
    if (WithLabel(first, segment.Label) == nullptr)
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
  StructurePairs pairs = ByLabel(one, first, other, second);
  if (pairs.Pairs.empty())
  {
    Refuse(one.Path(), "and " + other.Path().string() + " have no label in common",
           "choose a structure of each with --label and --reference-label");
  }
  return pairs;
}
} // namespace palpate
