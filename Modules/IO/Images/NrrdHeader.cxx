#include "NrrdHeader.h"

#include "DecimalText.h"
#include "Refusal.h"
#include "ZlibCheck.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
struct Header
{
  std::map<std::string, std::string> Fields;
  std::uint64_t Bytes = 0; // where the data of an attached header start
};

Header ReadHeader(const std::filesystem::path& file)
{
  Header header;
  std::ifstream stream(file, std::ios::binary);
  for (std::string line;
       NextNrrdLine(stream, line) && !line.empty() && line.size() < LongestNrrdLine;)
  {
    if (std::optional<NrrdField> field = ParseNrrdField(line))
    {
      header.Fields[field->Name] = std::move(field->Value);
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

// The data file: the file itself or one next to it; empty for several files.
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

bool NextNrrdLine(std::istream& stream, std::string& line)
{
  line.clear();
  for (int letter = stream.get(); letter != std::char_traits<char>::eof(); letter = stream.get())
  {
    // For the library, a carriage return ends a line too.
    if (letter == '\r' && stream.peek() == '\n')
    {
      stream.ignore();
    }
    if (letter == '\n' || letter == '\r')
    {
      return true;
    }
    if (line.size() <= LongestNrrdLine)
    {
      line += static_cast<char>(letter);
    }
  }
  return !line.empty();
}

// As in the library: a line is a field if ": " comes before ":=".
std::optional<NrrdField> ParseNrrdField(const std::string& line)
{
  const std::size_t end = line.find(": ");
  if (end == std::string::npos || line[0] == '#' || line.find(":=") < end)
  {
    return std::nullopt;
  }
  NrrdField field;
  for (const char letter : line.substr(0, end))
  {
    if (letter != ' ' && letter != '\t')
    {
      field.Name += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
  }
  const std::size_t first = std::min(line.find_first_not_of(" \t", end + 1), line.size());
  field.Value = line.substr(first, std::max(line.find_last_not_of(" \t") + 1, first) - first);
  return field;
}

std::map<std::string, std::string> ReadNrrdFields(const std::filesystem::path& file)
{
  return ReadHeader(file).Fields;
}

void CheckNrrdHeader(const std::filesystem::path& file)
{
  const Header header = ReadHeader(file);
  if (const std::string encoding = Field(header, "encoding");
      encoding == "bzip2" || encoding == "bz2")
  {
    Refuse(file, "has voxels that are compressed by bzip2, which is not supported",
           "write it again with the encoding gzip or raw");
  }
  const bool hasOtherAxis = Field(header, "spacedirections").find("none") != std::string::npos;
  if (hasOtherAxis && Field(header, "kinds").empty())
  {
    Refuse(file,
           "has an axis without a direction in space, but no \"kinds\" that say whether its values "
           "are layers, colours or times",
           "add kinds to its header, such as \"list domain domain domain\"");
  }
  const std::filesystem::path data = DataFile(file, header);
  std::error_code failure;
  if (!data.empty() && !std::filesystem::exists(data, failure))
  {
    Refuse(file, "lacks its data file " + data.string(), "put it next to the header");
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
  // The raw length; hexadecimal data need more. Text has at least two characters for up to eight
  // bytes.
  const bool isText = encoding == "text" || encoding == "txt" || encoding == "ascii";
  if (length < (isText ? dataBytes / 4.0 - 1.0 : dataBytes))
  {
    Refuse(file,
           "is truncated: its header declares " + SignificantText(dataBytes) +
               " bytes of voxels but there are " + SignificantText(length),
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
