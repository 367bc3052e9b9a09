#include "NrrdHeader.h"

#include "Refusal.h"
#include "ZlibCheck.h"

#include <cctype>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <system_error>

namespace palpate
{
namespace
{
// No line of a real header is longer; binary data have no line ends.
constexpr std::size_t LongestLine = 1U << 20;

struct Header
{
  std::map<std::string, std::string> Fields;
  std::uint64_t Bytes = 0; // where the data of an attached header start
};

// Field names are the same in either case, and some are known with and without blanks.
std::string Normalised(const std::string& name)
{
  std::string normalised;
  for (const char letter : name)
  {
    if (letter != ' ')
    {
      normalised += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
  }
  return normalised;
}

Header ReadHeader(const std::filesystem::path& file)
{
  Header header;
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  while (std::getline(stream, line) && !line.empty() && line != "\r" && line.size() < LongestLine)
  {
    const std::string key = line.substr(0, line.find(':'));
    const auto first = line.find_first_not_of(" \t\r", key.size() + 1);
    if (first != std::string::npos && line[0] != '#' && line[key.size() + 1] != '=')
    {
      header.Fields[Normalised(key)] =
          line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
    }
  }
  header.Bytes = stream ? static_cast<std::uint64_t>(stream.tellg()) : 0;
  return header;
}

std::string Field(const Header& header, const std::string& key)
{
  const auto found = header.Fields.find(key);
  return found == header.Fields.end() ? std::string() : found->second;
}

// Where the data lie: the file itself or one beside it; empty for several files.
std::filesystem::path DataFile(const std::filesystem::path& file, const Header& header)
{
  const std::string name = Field(header, "datafile");
  const bool areSeveral = name.rfind("LIST", 0) == 0 || name.find('%') != std::string::npos;
  if (areSeveral)
  {
    return {};
  }
  return name.empty() ? file : file.parent_path() / name;
}
} // namespace

std::map<std::string, std::string> ReadNrrdFields(const std::filesystem::path& file)
{
  return ReadHeader(file).Fields;
}

void CheckNrrdHeader(const std::filesystem::path& file)
{
  const std::filesystem::path data = DataFile(file, ReadHeader(file));
  std::error_code failure;
  if (!data.empty() && !std::filesystem::exists(data, failure))
  {
    Refuse(file, "lacks its data file " + data.string(), "put it beside the header");
  }
}

void CheckNrrdLength(const std::filesystem::path& file, double dataBytes)
{
  const Header header = ReadHeader(file);
  const std::string encoding = Field(header, "encoding");
  const std::filesystem::path data = DataFile(file, header);
  if (data.empty())
  {
    return;
  }
  const double start = data == file ? static_cast<double>(header.Bytes) : 0.0;
  const double length = static_cast<double>(std::filesystem::file_size(data)) - start;
  if (encoding == "gzip" || encoding == "gz")
  {
    return CheckInflatedSize(file, length, dataBytes);
  }
  // Raw; in hexadecimal they need more. Text has at least two letters for up to eight bytes.
  const bool isText = encoding == "text" || encoding == "txt" || encoding == "ascii";
  if (length < (isText ? dataBytes / 4.0 - 1.0 : dataBytes))
  {
    Refuse(file,
           "is truncated: its header promises " + NumberText(dataBytes) +
               " bytes of voxels and there are " + NumberText(length),
           "copy or export it again");
  }
}

void CheckNrrdData(const std::filesystem::path& file, std::uint64_t dataBytes)
{
  const Header header = ReadHeader(file);
  const std::string encoding = Field(header, "encoding");
  const bool skips = !Field(header, "lineskip").empty() || !Field(header, "byteskip").empty();
  const std::filesystem::path data = DataFile(file, header);
  if ((encoding == "gzip" || encoding == "gz") && !skips && !data.empty())
  {
    CheckedInflatedBytes(data, data == file ? header.Bytes : 0, dataBytes);
  }
}
} // namespace palpate
