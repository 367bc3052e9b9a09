#include "SegmentCodes.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{
namespace
{
constexpr const char* EntryTag = "TerminologyEntry:";

// The part of a text with this index between separators; empty if there are fewer.
std::string Part(const std::string& text, char separator, std::size_t index)
{
  std::size_t first = 0;
  for (; index > 0; --index)
  {
    const std::size_t end = text.find(separator, first);
    if (end == std::string::npos)
    {
      return {};
    }
    first = end + 1;
  }
  return text.substr(first, text.find(separator, first) - first);
}

CodedTerm TermOf(const std::string& text)
{
  return {Part(text, '^', 0), Part(text, '^', 1), Part(text, '^', 2)};
}

std::string TextOf(const CodedTerm& term)
{
  std::string text;
  for (std::string part : {term.Scheme, term.Value, term.Meaning})
  {
    std::replace_if(
        part.begin(), part.end(),
        [](unsigned char c) { return c < ' ' || c == '^' || c == '~' || c == '|'; }, ' ');
    text += part + "^";
  }
  text.pop_back();
  return text;
}
} // namespace

// The parts of an entry: context, category, type, modifier, context of regions, region, modifier.
SegmentCodes CodesOfSlicerTags(const std::string& tags)
{
  const std::size_t start = tags.find(EntryTag);
  if (start == std::string::npos)
  {
    return {};
  }
  const std::string entry = Part(tags.substr(start), '|', 0);
  SegmentCodes codes;
  codes.Category = TermOf(Part(entry, '~', 1));
  codes.Type = TermOf(Part(entry, '~', 2));
  codes.TypeModifier = TermOf(Part(entry, '~', 3));
  codes.Region = TermOf(Part(entry, '~', 5));
  codes.RegionModifier = TermOf(Part(entry, '~', 6));
  return codes;
}

std::string SlicerTagsOf(const SegmentCodes& codes)
{
  if (codes.Category.Value.empty())
  {
    return {};
  }
  return std::string(EntryTag) + "Segmentation category and type - DICOM master list~" +
         TextOf(codes.Category) + "~" + TextOf(codes.Type) + "~" + TextOf(codes.TypeModifier) +
         "~Anatomic codes - DICOM master list~" + TextOf(codes.Region) + "~" +
         TextOf(codes.RegionModifier) + "|";
}
} // namespace palpate
