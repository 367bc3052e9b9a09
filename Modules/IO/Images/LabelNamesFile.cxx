#include "LabelNamesFile.h"

#include "ImageFormat.h"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
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

constexpr const char* FreeSurferTable = "FreeSurferColorLUT.txt";
constexpr const char* DatasetTable = "dataset.json"; // nnU-Net's
constexpr std::uintmax_t LargestTable = 1U << 20;

// Bytes of a regular file, 0 of anything else.
std::uintmax_t SizeOf(const std::filesystem::path& file)
{
  std::error_code failure;
  const bool isFile = std::filesystem::is_regular_file(file, failure);
  const std::uintmax_t bytes = isFile ? std::filesystem::file_size(file, failure) : 0;
  return failure ? 0 : bytes;
}

std::optional<LabelTable> ReadTable(const std::filesystem::path& file)
{
  if (SizeOf(file) == 0 || SizeOf(file) > LargestTable)
  {
    return std::nullopt;
  }
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (file.extension() == ".json")
  {
    return LabelsOfDataset(text);
  }
  const auto columns = LabelColumns(text);
  return columns ? columns : LabelLines(text);
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

// Not named after an image.
bool IsForFolder(const std::filesystem::path& table)
{
  return table.filename() == FreeSurferTable || table.filename() == DatasetTable;
}

// Whether it knows any of the labels.
bool Apply(const LabelTable& table, Segmentation& segmentation)
{
  bool isKnown = false;
  for (Segment& segment : segmentation.Segments)
  {
    const auto entry = table.find(segment.Value);
    if (entry != table.end())
    {
      isKnown = true;
      segment.Name = entry->second.Name;
      segment.Color = entry->second.Color.value_or(segment.Color);
    }
  }
  return isKnown;
}
} // namespace

std::vector<std::filesystem::path> LabelTablesOf(const std::filesystem::path& image)
{
  std::vector<std::filesystem::path> files{NextTo(image, ".txt")};
  const std::filesystem::path folder = image.parent_path();
  const std::string name = ImageNameOf(image);
  for (const char* ending : {".label", ".lbl", ".label.txt", ".label.tsv", ".label.csv", ".tsv",
                             ".csv", ".txt", ".ctab", ".ctbl"})
  {
    files.push_back(folder / (name + ending));
  }
  files.push_back(folder / FreeSurferTable);
  files.push_back(folder / DatasetTable);
  files.push_back(folder / ".." / DatasetTable); // of nnU-Net's labelsTr
  return files;
}

void ApplyLabelNames(Segmentation& segmentation, const LabelTable& own)
{
  const bool isNamed = Apply(own, segmentation);
  ApplyColors(NextTo(segmentation.Source, ".lut"), segmentation);
  const std::vector<std::filesystem::path> files = LabelTablesOf(segmentation.Source);
  for (const std::filesystem::path& file : files)
  {
    const auto table = isNamed && IsForFolder(file) ? std::nullopt : ReadTable(file);
    if (table && Apply(*table, segmentation))
    {
      segmentation.Notes.push_back("Names of the labels are from " +
                                   file.lexically_normal().string() + ".");
      return;
    }
  }
  // The others may be anything.
  std::error_code isNoFile; // such as a name that is too long with the ending
  if (std::filesystem::exists(files.front(), isNoFile))
  {
    segmentation.Notes.push_back(files.front().string() +
                                 " is not a list of label names and was not used.");
  }
}
} // namespace palpate
