#include "MetaImageFields.h"

#include "ForeignFile.h"
#include "Refusal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

namespace palpate
{
namespace
{
// No line of a real header is longer; a binary file may have no line ends.
constexpr std::size_t LongestLine = 4096;
// The library allocates a 33 kB record for each unknown line.
constexpr std::size_t MostLines = 10000;
// The library copies keys into 255 bytes; the format's own have some twenty characters.
constexpr std::size_t LongestKey = 100;
// The same holds for words, and for numbers that it reads as words.
constexpr std::size_t LongestWord = 254;
// It reads up to 499 characters of the one word with a larger buffer.
constexpr std::size_t LongestName = 490;

// How many numbers the library reads from a field: `Factor` times the dimension to this power.
struct NumberCount
{
  int Factor;
  int Power;
};

const std::map<std::string, NumberCount>& NumberCounts()
{
  static const std::map<std::string, NumberCount> counts{
      {"NDims", {1, 0}},
      {"ID", {1, 0}},
      {"ParentID", {1, 0}},
      {"CompressedDataSize", {1, 0}},
      {"HeaderSize", {1, 0}},
      {"ElementMin", {1, 0}},
      {"ElementMax", {1, 0}},
      {"ElementNumberOfChannels", {1, 0}},
      {"ElementNBits", {1, 0}},
      {"ElementToIntensityFunctionSlope", {1, 0}},
      {"ElementToIntensityFunctionOffset", {1, 0}},
      {"Color", {4, 0}},
      {"DimSize", {1, 1}},
      {"Position", {1, 1}},
      {"Origin", {1, 1}},
      {"Offset", {1, 1}},
      {"CenterOfRotation", {1, 1}},
      {"ElementSpacing", {1, 1}},
      {"ElementSize", {1, 1}},
      {"ImagePosition", {1, 1}},
      {"SequenceID", {1, 1}},
      {"TransformMatrix", {1, 2}},
      {"Rotation", {1, 2}},
      {"Orientation", {1, 2}}};
  return counts;
}

std::size_t MostLetters(const std::string& key)
{
  return key == "ElementDataFile"         ? LongestName
         : NumberCounts().count(key) == 0 ? LongestWord
                                          : LongestLine;
}

bool IsControl(char letter)
{
  const auto code = static_cast<unsigned char>(letter);
  return code < 0x20 && letter != '\t';
}

std::string Trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t");
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// The library strips unprintable characters from the end of a word.
std::string WithoutEnd(std::string word)
{
  while (!word.empty() && (word.back() <= ' ' || word.back() > '~'))
  {
    word.pop_back();
  }
  return word;
}

class FieldsReader
{
public:
  explicit FieldsReader(const std::filesystem::path& file)
      : File(file), Stream(file, std::ios::binary)
  {
  }

  MetaImageFields Read()
  {
    for (std::size_t lines = 0; this->Fields.Entries.count("ElementDataFile") == 0; ++lines)
    {
      if (lines == MostLines)
      {
        Refuse(this->File, "has more than " + std::to_string(MostLines) + " lines in its header",
               "export it again without them");
      }
      this->TakeLine(this->NextLine());
    }
    this->CheckCounts();
    return std::move(this->Fields);
  }

private:
  std::string NextLine()
  {
    std::array<char, LongestLine> letters{};
    if (!this->Stream.getline(letters.data(), letters.size()))
    {
      this->RefuseHeader("is not a MetaImage file, or its header is truncated or damaged");
    }
    // The count includes the line end, except at the end of the file.
    const auto count = static_cast<std::size_t>(this->Stream.gcount());
    this->Fields.Bytes += count;
    std::string line(letters.data(), this->Stream.eof() ? count : count - 1);
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    return line;
  }

  void TakeLine(const std::string& line)
  {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || equals > LongestKey ||
        std::any_of(line.begin(), line.end(), IsControl))
    {
      this->RefuseHeader("is not a MetaImage file, or its header is truncated or damaged");
    }
    if (line.find(':') < equals)
    {
      this->RefuseHeader("has a header line with a colon before the equals sign");
    }
    const std::string key = Trimmed(line.substr(0, equals));
    const std::size_t start = std::min(line.find_first_not_of(" \t", equals + 1), line.size());
    if (start < line.size() && (line[start] == '=' || line[start] == ':'))
    {
      this->RefuseHeader("has a header line with two separators in a row");
    }
    if (line.size() - start > MostLetters(key))
    {
      Refuse(this->File,
             "has " + std::to_string(line.size() - start) + " characters of " + key +
                 " in its header, where at most " + std::to_string(MostLetters(key)) +
                 " are allowed",
             "shorten them");
    }
    if (!this->Fields.Entries.emplace(key, WithoutEnd(line.substr(start))).second)
    {
      Refuse(this->File, "has " + key + " more than once in its header", "copy or export it again");
    }
  }

  void CheckCounts() const
  {
    const std::vector<double> dimensions = this->Fields.Numbers("NDims");
    const double count = dimensions.empty() ? 0.0 : dimensions[0];
    for (const auto& [key, numbers] : NumberCounts())
    {
      if (this->Fields.Entries.count(key) > 0 &&
          !(static_cast<double>(this->Fields.Numbers(key).size()) >=
            numbers.Factor * std::pow(std::floor(count), numbers.Power)))
      {
        Refuse(this->File, "has a damaged header (" + key + ")", "copy or export it again");
      }
    }
  }

  [[noreturn]] void RefuseHeader(const std::string& fact) const
  {
    RefuseContent(this->File, fact, "copy or export it again");
  }

  std::filesystem::path File;
  std::ifstream Stream;
  MetaImageFields Fields;
};
} // namespace

std::string MetaImageFields::Text(const std::string& key) const
{
  const auto entry = this->Entries.find(key);
  return entry == this->Entries.end() ? std::string() : entry->second;
}

std::vector<double> MetaImageFields::Numbers(const std::string& key) const
{
  std::vector<double> numbers;
  std::istringstream text(this->Text(key));
  for (double number = 0.0; text >> number;)
  {
    numbers.push_back(number);
  }
  return numbers;
}

bool MetaImageFields::IsTrue(const std::string& key, bool otherwise) const
{
  const auto entry = this->Entries.find(key);
  if (entry == this->Entries.end())
  {
    return otherwise;
  }
  const std::string& value = entry->second;
  return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
}

MetaImageFields ReadMetaImageFields(const std::filesystem::path& file)
{
  return FieldsReader(file).Read();
}
} // namespace palpate
