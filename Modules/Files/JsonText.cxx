#include "JsonText.h"

#include "AvailableMemory.h"
#include "Refusal.h"
#include "WholeFile.h"

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
constexpr std::size_t MostDepth = 64;
constexpr std::size_t MostOrderedKeys = 10000;
constexpr double BytesOfValue = 64.0; // of a small list, with the allocator's overhead

// The properties of a text that determine the cost of parsing it.
struct JsonExtent
{
  std::size_t Depth = 0;
  std::size_t Keys = 0;
  std::size_t Values = 0;
};

// Exact for valid JSON; for other text, exact up to the first error, where the parser stops.
JsonExtent ExtentOf(std::string_view text)
{
  JsonExtent extent;
  std::size_t depth = 0;
  bool isInString = false;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char letter = text[i];
    if (isInString && letter == '\\')
    {
      ++i;
    }
    else if (letter == '"')
    {
      isInString = !isInString;
    }
    else if (isInString)
    {
      continue;
    }
    else if (letter == '[' || letter == '{')
    {
      extent.Depth = std::max(extent.Depth, ++depth);
      ++extent.Values;
    }
    else if (letter == ']' || letter == '}')
    {
      depth -= depth > 0 ? 1 : 0;
    }
    extent.Keys += !isInString && letter == ':' ? 1 : 0;
    extent.Values += !isInString && letter == ',' ? 1 : 0;
  }
  return extent;
}

// "line 3, column 14" of a byte, both from 1.
std::string PlaceText(std::string_view text, std::size_t byte)
{
  const std::size_t end = std::min(byte > 0 ? byte - 1 : 0, text.size());
  const auto stop = text.begin() + static_cast<std::ptrdiff_t>(end);
  const auto line = 1 + std::count(text.begin(), stop, '\n');
  const std::size_t before = end > 0 ? text.rfind('\n', end - 1) : std::string_view::npos;
  const std::size_t column = end - (before == std::string_view::npos ? 0 : before + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

template <typename Json>
Json Parse(std::string_view text, const std::filesystem::path& file, const std::string& remedy,
           std::size_t mostKeys)
{
  const JsonExtent extent = ExtentOf(text);
  if (extent.Depth > MostDepth)
  {
    Refuse(file,
           "cannot be read: its JSON is nested more than " + std::to_string(MostDepth) + " deep",
           remedy);
  }
  if (extent.Keys > mostKeys)
  {
    Refuse(file, "cannot be read: its JSON has more than " + std::to_string(mostKeys) + " keys",
           remedy);
  }
  CheckMemory(file, BytesOfValue * static_cast<double>(extent.Values));
  try
  {
    return Json::parse(text);
  }
  catch (const nlohmann::json::parse_error& error)
  {
    Refuse(file, "is not valid JSON at " + PlaceText(text, error.byte), remedy);
  }
  catch (const nlohmann::json::out_of_range&)
  {
    Refuse(file, "cannot be read: it holds a number that is too large", remedy);
  }
}
} // namespace

nlohmann::json ParseJson(std::string_view text, const std::filesystem::path& file,
                         const std::string& remedy)
{
  return Parse<nlohmann::json>(text, file, remedy, std::numeric_limits<std::size_t>::max());
}

nlohmann::ordered_json ParseOrderedJson(std::string_view text, const std::filesystem::path& file,
                                        const std::string& remedy)
{
  return Parse<nlohmann::ordered_json>(text, file, remedy, MostOrderedKeys);
}

nlohmann::json ReadJson(const std::filesystem::path& file, std::uintmax_t maximumBytes,
                        const std::string& remedy)
{
  return ParseJson(ReadWholeFile(file, maximumBytes), file, remedy);
}
} // namespace palpate
