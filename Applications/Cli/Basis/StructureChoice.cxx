#include "StructureChoice.h"

#include "DecimalText.h"
#include "InputError.h"

#include <algorithm>
#include <sstream>

namespace palpate::cli
{
namespace
{
bool HasName(const Segmentation& segmentation, const std::string& name)
{
  return std::any_of(segmentation.Segments.begin(), segmentation.Segments.end(),
                     [&](const Segment& segment) { return segment.Name == name; });
}

// A whole name may have commas; other words are split at them.
std::vector<std::string> Parts(const Segmentation& segmentation, const std::string& word)
{
  if (HasName(segmentation, word))
  {
    return {word};
  }
  std::vector<std::string> parts;
  std::istringstream stream(word);
  for (std::string part; std::getline(stream, part, ',');)
  {
    if (!part.empty())
    {
      parts.push_back(part);
    }
  }
  return parts.empty() ? std::vector<std::string>{word} : parts;
}

Segment Named(const std::string& word)
{
  Segment segment;
  segment.Label = ParseInteger(word).value_or(0);
  segment.Name = segment.Label == 0 ? word : std::string();
  return segment;
}

void Choose(const Segmentation& segmentation, const std::string& part, StructureChoice& choice)
{
  try
  {
    const Segment& found = segmentation.Find(part);
    if (std::none_of(choice.Found.begin(), choice.Found.end(),
                     [&](const Segment& segment) { return segment.Label == found.Label; }))
    {
      choice.Found.push_back(found);
    }
  }
  catch (const InputError& error)
  {
    choice.Lost.push_back({Named(part), error.what()});
  }
}
} // namespace

StructureChoice ChooseStructures(const Segmentation& segmentation,
                                 const std::vector<std::string>& words)
{
  StructureChoice choice;
  if (words.empty())
  {
    choice.Found = segmentation.Segments;
  }
  for (const std::string& word : words)
  {
    for (const std::string& part : Parts(segmentation, word))
    {
      Choose(segmentation, part, choice);
    }
  }
  return choice;
}
} // namespace palpate::cli
