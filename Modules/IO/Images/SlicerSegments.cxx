#include "SlicerSegments.h"

#include "SegmentColor.h"

#include <algorithm>
#include <locale>
#include <sstream>

namespace palpate
{
namespace
{
using Entries = std::map<std::string, std::string>;

std::string TextOf(const Entries& entries, const std::string& key)
{
  const auto entry = entries.find(key);
  return entry == entries.end() ? std::string() : entry->second;
}

int NumberOf(const Entries& entries, const std::string& key, int fallback)
{
  std::istringstream text(TextOf(entries, key));
  int number = 0;
  return text >> number ? number : fallback;
}

std::array<double, 3> ColorOf(const Entries& entries, const std::string& key, int label)
{
  std::istringstream text(TextOf(entries, key));
  text.imbue(std::locale::classic());
  std::array<double, 3> color{};
  if (!(text >> color[0] >> color[1] >> color[2]))
  {
    return DefaultSegmentColor(label);
  }
  std::transform(color.begin(), color.end(), color.begin(),
                 [](double channel) { return std::clamp(channel, 0.0, 1.0); });
  return color;
}
} // namespace

std::vector<Segment> SlicerSegments(const Entries& headerEntries)
{
  std::vector<Segment> segments;
  for (int number = 0;; ++number)
  {
    const std::string prefix = "Segment" + std::to_string(number) + "_";
    const auto next = headerEntries.lower_bound(prefix);
    if (next == headerEntries.end() || next->first.compare(0, prefix.size(), prefix) != 0)
    {
      return segments;
    }
    const bool hasValue = headerEntries.count(prefix + "LabelValue") > 0;
    Segment segment;
    segment.Value = NumberOf(headerEntries, prefix + "LabelValue", 1);
    segment.Label = segment.Value;
    segment.Layer = NumberOf(headerEntries, prefix + "Layer", hasValue ? 0 : number);
    segment.Name = TextOf(headerEntries, prefix + "Name");
    segment.Color = ColorOf(headerEntries, prefix + "Color", number + 1);
    segment.Codes = CodesOfSlicerTags(TextOf(headerEntries, prefix + "Tags"));
    segments.push_back(segment);
  }
}
} // namespace palpate
