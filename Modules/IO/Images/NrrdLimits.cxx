#include "NrrdLimits.h"

#include "DecimalText.h"
#include "NrrdHeader.h"
#include "Refusal.h"

#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>

namespace palpate
{
namespace
{
constexpr std::size_t LongestField = 512;
constexpr std::size_t LongestPath = 512;
constexpr std::size_t MostPairs = 20000;
constexpr int MostDimensions = 10;

/// Checks a header line by line.
class HeaderCheck
{
public:
  explicit HeaderCheck(const std::filesystem::path& file) : File(file) {}

  void Run()
  {
    if (this->File.string().size() > LongestPath)
    {
      Refuse(this->File, "has a path of more than " + std::to_string(LongestPath) + " characters",
             "move it");
    }
    std::ifstream stream(this->File, std::ios::binary);
    for (std::string line; NextNrrdLine(stream, line) && !line.empty();)
    {
      this->TakeLine(line);
      if (this->IsList)
      {
        return this->CheckList(stream);
      }
    }
  }

private:
  void TakeLine(const std::string& line)
  {
    if (line.size() > LongestNrrdLine)
    {
      this->RefuseLine(line);
    }
    if (line.find('\0') != std::string::npos)
    {
      Refuse(this->File, "has a line in its header with a null byte", "copy or export it again");
    }
    if (line[0] == '#')
    {
      return;
    }
    // If the text before ":=" is long, the library may take a ": " in it for the end of a field's
    // name.
    const std::size_t pair = line.find(":=");
    if (pair < line.find(": ") && pair < LongestField)
    {
      return this->CountPair();
    }
    if (line.size() > LongestField)
    {
      this->RefuseLine(line);
    }
    if (const std::optional<NrrdField> field = ParseNrrdField(line))
    {
      this->TakeField(field->Name, field->Value);
    }
  }

  void TakeField(const std::string& name, const std::string& text)
  {
    if (name == "dimension")
    {
      const auto count = ParseInteger(text);
      if (!count)
      {
        Refuse(this->File, "is not an NRRD image, or its header is damaged",
               "copy or export it again");
      }
      if (*count < 1 || *count > MostDimensions)
      {
        Refuse(this->File, "has " + text + " dimensions",
               "extract one three-dimensional volume of it");
      }
    }
    if (name == "sizes")
    {
      this->CheckSizes(text);
    }
    if (name == "datafile")
    {
      this->TakeDataFile(text);
    }
  }

  // The readers store sizes, and values per voxel, as int.
  void CheckSizes(const std::string& text) const
  {
    std::istringstream words(text);
    for (std::string word; words >> word;)
    {
      if (const auto size = ParseInteger(word); !size || *size < 1)
      {
        Refuse(this->File, "has a damaged header (sizes: " + text + ")", "copy or export it again");
      }
    }
  }

  void TakeDataFile(const std::string& name)
  {
    this->IsList = name.rfind("LIST", 0) == 0;
    if (name.find('%') != std::string::npos)
    {
      Refuse(this->File, "names its data files by a pattern", "write it with one data file");
    }
    if (!this->IsList)
    {
      this->CheckDataFile(name);
    }
  }

  // A missing data file has its own message.
  void CheckDataFile(const std::string& name) const
  {
    std::error_code failure;
    const std::filesystem::path data = this->File.parent_path() / name;
    if (name == "-" || (std::filesystem::exists(data, failure) &&
                        !std::filesystem::is_regular_file(data, failure)))
    {
      Refuse(this->File, "names a data file " + name + " that is not a regular file",
             "write it with its data");
    }
  }

  void CheckList(std::istream& stream) const
  {
    for (std::string line; NextNrrdLine(stream, line);)
    {
      if (line.size() > LongestField)
      {
        this->RefuseLine(line);
      }
      const std::size_t end = line.find_last_not_of(" \t");
      this->CheckDataFile(line.substr(0, end == std::string::npos ? 0 : end + 1));
    }
  }

  void CountPair()
  {
    if (++this->Pairs > MostPairs)
    {
      Refuse(this->File,
             "has more than " + std::to_string(MostPairs) + " key/value pairs in its header",
             "export fewer segments at a time");
    }
  }

  [[noreturn]] void RefuseLine(const std::string& line) const
  {
    Refuse(this->File,
           "is not an NRRD image, or its header is damaged: one of its lines has " +
               std::to_string(line.size()) + (line.size() > LongestNrrdLine ? " and more" : "") +
               " characters",
           "copy or export it again");
  }

  const std::filesystem::path& File;
  std::size_t Pairs = 0;
  bool IsList = false;
};
} // namespace

void CheckNrrdLimits(const std::filesystem::path& file)
{
  HeaderCheck(file).Run();
}
} // namespace palpate
