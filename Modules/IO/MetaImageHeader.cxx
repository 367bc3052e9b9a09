#include "MetaImageHeader.h"

#include "CNumericLocale.h"
#include "ForeignFile.h"
#include "Refusal.h"
#include "ZlibCheck.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
// No line of a real header is longer; a binary file has no line ends.
constexpr std::size_t LongestLine = 4096;
// The library copies keys into 255 bytes; those of the format have some twenty letters.
constexpr std::size_t LongestKey = 100;
// So it does with words; numbers it parses.
constexpr std::size_t LongestWord = 254;

struct Header
{
  std::map<std::string, std::string> Entries;
  double Bytes = 0.0; // where the data of a LOCAL file start
};

std::string Trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t\r");
  return first == std::string::npos
             ? std::string()
             : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

Header ReadHeader(const std::filesystem::path& file)
{
  Header header;
  std::ifstream stream(file, std::ios::binary);
  std::array<char, LongestLine> letters{};
  while (stream.getline(letters.data(), letters.size()))
  {
    const std::string line(letters.data());
    const auto equals = line.find('=');
    if (equals == std::string::npos || equals > LongestKey)
    {
      break;
    }
    const std::string key = Trimmed(line.substr(0, equals));
    const std::string value = Trimmed(line.substr(equals + 1));
    if (value.size() > LongestWord && value.find_first_not_of("0123456789+-.eE \t") != value.npos)
    {
      break;
    }
    header.Entries[key] = value;
    if (key == "ElementDataFile")
    {
      header.Bytes = static_cast<double>(stream.tellg());
      return header;
    }
  }
  RefuseContent(file, "is no MetaImage file or ends or is damaged within its header",
                "copy or export it again");
}

std::vector<double> Numbers(const Header& header, const std::string& key)
{
  std::vector<double> numbers;
  const auto entry = header.Entries.find(key);
  if (entry != header.Entries.end())
  {
    std::istringstream text(entry->second);
    for (double number = 0.0; text >> number;)
    {
      numbers.push_back(number);
    }
  }
  return numbers;
}

// The sizes of three axes.
std::vector<double> CheckDimensions(const std::filesystem::path& file, const Header& header)
{
  const std::vector<double> count = Numbers(header, "NDims");
  std::vector<double> sizes = Numbers(header, "DimSize");
  if (count.size() != 1 || count[0] < 1 || count[0] > 10 || sizes.size() != std::size_t(count[0]))
  {
    Refuse(file, "has a damaged header (NDims, DimSize)", "copy or export it again");
  }
  for (std::size_t axis = 0; axis < sizes.size(); ++axis)
  {
    if (!(sizes[axis] >= 1.0 && sizes[axis] <= 1e9) || sizes[axis] != std::floor(sizes[axis]))
    {
      Refuse(file,
             "has " + NumberText(sizes[axis]) + " voxels along axis " + std::to_string(axis + 1),
             "copy or export it again");
    }
    if (axis > 2 && sizes[axis] > 1.0)
    {
      Refuse(file, "has " + NumberText(count[0]) + " dimensions",
             "extract one three-dimensional volume of it");
    }
  }
  if (sizes.size() < 3)
  {
    Refuse(file, "is two-dimensional", "give a volume of at least two slices");
  }
  sizes.resize(3);
  return sizes;
}

void CheckSpacings(const std::filesystem::path& file, const Header& header)
{
  for (const char* key : {"ElementSpacing", "ElementSize"})
  {
    for (const double spacing : Numbers(header, key))
    {
      if (!(std::isfinite(spacing) && spacing > 0.0))
      {
        Refuse(file, "has a voxel spacing of " + NumberText(spacing) + " mm",
               "correct its header: spacings must be positive");
      }
    }
  }
}

double BytesOfType(const std::filesystem::path& file, const Header& header)
{
  static const std::map<std::string, double> sizes{
      {"MET_CHAR", 1},      {"MET_UCHAR", 1},      {"MET_SHORT", 2}, {"MET_USHORT", 2},
      {"MET_INT", 4},       {"MET_UINT", 4},       {"MET_LONG", 4},  {"MET_ULONG", 4},
      {"MET_LONG_LONG", 8}, {"MET_ULONG_LONG", 8}, {"MET_FLOAT", 4}, {"MET_DOUBLE", 8}};
  const auto type = header.Entries.find("ElementType");
  const auto size = type == header.Entries.end() ? sizes.end() : sizes.find(type->second);
  if (size == sizes.end())
  {
    Refuse(file, "has no scalar ElementType in its header",
           "give one grey value or label per voxel");
  }
  return size->second;
}

bool IsCompressed(const Header& header)
{
  const auto entry = header.Entries.find("CompressedData");
  const std::string value = entry == header.Entries.end() ? std::string() : entry->second;
  return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
}

// Of data in the header's own file the library must be told the length: else it decodes from the
// file's first byte.
void CheckCompressedData(const std::filesystem::path& data, const Header& header, double start,
                         double dataBytes)
{
  const std::vector<double> stated = Numbers(header, "CompressedDataSize");
  const bool isStated = stated.size() == 1 && stated[0] >= 1.0 && stated[0] <= 1e15;
  if (!isStated && start > 0.0)
  {
    Refuse(data, "is compressed and has no CompressedDataSize in its header",
           "write it again, for example without compression");
  }
  CheckInflatedSize(data, static_cast<double>(std::filesystem::file_size(data)) - start, dataBytes);
  const auto bytes = static_cast<double>(CheckedInflatedBytes(
      data, static_cast<std::uint64_t>(start), static_cast<std::uint64_t>(dataBytes),
      isStated ? static_cast<std::uint64_t>(stated[0]) : UINT64_MAX));
  if (bytes != dataBytes)
  {
    Refuse(data,
           std::string(bytes < dataBytes ? "is truncated" : "is damaged") +
               ": its header promises " + std::to_string(std::llround(dataBytes)) +
               " bytes of voxels and its compressed data hold " +
               std::to_string(std::llround(bytes)),
           "copy or export it again");
  }
}

void CheckLength(const std::filesystem::path& file, const Header& header, double dataBytes)
{
  const std::string name = header.Entries.at("ElementDataFile");
  const bool isLocal = name == "LOCAL" || name == "Local" || name == "local";
  const std::filesystem::path data = isLocal ? file : file.parent_path() / name;
  if (name.empty() || name.rfind("LIST", 0) == 0 || name.find('%') != std::string::npos)
  {
    Refuse(file, "keeps its slices in several files", "write it as one file");
  }
  std::error_code failure;
  const auto length = std::filesystem::file_size(data, failure);
  if (failure)
  {
    Refuse(file, "lacks its data file " + data.string(), "put it beside the header");
  }
  const double start = isLocal ? header.Bytes : 0.0;
  const double available = static_cast<double>(length) - start;
  if (IsCompressed(header))
  {
    return CheckCompressedData(data, header, start, dataBytes);
  }
  if (available < dataBytes)
  {
    Refuse(file,
           "is truncated: its header promises " + std::to_string(std::llround(dataBytes)) +
               " bytes of voxels and there are " + std::to_string(std::llround(available)),
           "copy or export it again");
  }
}
std::vector<std::string> OrientationNotes(const Header& header)
{
  for (const char* key : {"TransformMatrix", "Rotation", "Orientation"})
  {
    if (header.Entries.count(key) > 0)
    {
      return {};
    }
  }
  return {"The file gives no TransformMatrix; its index axes were taken as L, P, S."};
}
} // namespace

std::vector<std::string> CheckMetaImageHeader(const std::filesystem::path& file)
{
  CNumericLocale::RequireOfStreams(file);
  const Header header = ReadHeader(file);
  const std::vector<double> sizes = CheckDimensions(file, header);
  CheckSpacings(file, header);
  const std::vector<double> channels = Numbers(header, "ElementNumberOfChannels");
  if (!channels.empty() && channels[0] != 1.0)
  {
    Refuse(file, "has " + NumberText(channels[0]) + " values per voxel",
           "give one grey value or label per voxel");
  }
  CheckLength(file, header, sizes[0] * sizes[1] * sizes[2] * BytesOfType(file, header));
  return OrientationNotes(header);
}
} // namespace palpate
