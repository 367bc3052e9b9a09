#include "LabelNamesFile.h"

#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <system_error>
#include <vector>

namespace palpate
{
namespace
{
std::filesystem::path NextTo(std::filesystem::path image, const char* ending)
{
  if (image.extension() == ".gz")
  {
    image.replace_extension();
  }
  image += ending;
  return image;
}

constexpr std::uintmax_t LargestNames = 1U << 20;

// Bytes of a regular file, 0 of anything else.
std::uintmax_t SizeOf(const std::filesystem::path& file)
{
  std::error_code failure;
  const bool isFile = std::filesystem::is_regular_file(file, failure);
  const std::uintmax_t bytes = isFile ? std::filesystem::file_size(file, failure) : 0;
  return failure ? 0 : bytes;
}

// Empty if the file is absent, too large for such a list, or has a line of another format.
std::optional<std::map<int, std::string>> ReadNames(const std::filesystem::path& file)
{
  std::map<int, std::string> names;
  if (SizeOf(file) == 0 || SizeOf(file) > LargestNames)
  {
    return std::nullopt;
  }
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line))
  {
    std::istringstream words(line);
    int label = 0;
    std::string name;
    if (line.find_first_not_of(" \t\r") == std::string::npos)
    {
      continue;
    }
    if (!(words >> label >> name))
    {
      return std::nullopt;
    }
    names[label] = name;
  }
  return names;
}

void ApplyColors(const std::filesystem::path& file, Segmentation& segmentation)
{
  constexpr std::size_t Entries = 256;
  std::vector<char> bytes(3 * Entries);
  if (SizeOf(file) != bytes.size() ||
      !std::ifstream(file, std::ios::binary).read(bytes.data(), 3 * Entries))
  {
    return;
  }
  for (Segment& segment : segmentation.Segments)
  {
    if (segment.Value < static_cast<int>(Entries))
    {
      for (std::size_t channel = 0; channel < 3; ++channel)
      {
        const char byte = bytes[channel * Entries + static_cast<std::size_t>(segment.Value)];
        segment.Color[channel] = static_cast<unsigned char>(byte) / 255.0;
      }
    }
  }
}
} // namespace

void ApplyLabelNames(Segmentation& segmentation)
{
  const std::filesystem::path namesFile = NextTo(segmentation.Source, ".txt");
  ApplyColors(NextTo(segmentation.Source, ".lut"), segmentation);
  std::error_code isNoFile; // such as a name that is too long with the ending
  if (!std::filesystem::exists(namesFile, isNoFile))
  {
    return;
  }
  const auto names = ReadNames(namesFile);
  if (!names)
  {
    segmentation.Notes.push_back(namesFile.string() +
                                 " is not a list of label names and was not used.");
    return;
  }
  for (Segment& segment : segmentation.Segments)
  {
    const auto name = names->find(segment.Value);
    segment.Name = name == names->end() ? segment.Name : name->second;
  }
  segmentation.Notes.push_back("Names of the labels are from " + namesFile.string() + ".");
}
} // namespace palpate
