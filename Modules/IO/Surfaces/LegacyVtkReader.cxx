#include "LegacyVtkReader.h"

#include "DecimalText.h"
#include "Refusal.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace palpate
{
namespace
{
constexpr std::string_view Blanks = " \t\r\n\v\f";

enum class Kind
{
  Signed,
  Unsigned,
  Real,
  Bit,
  Text
};

struct ValueType
{
  Kind Is;
  std::size_t Bytes; ///< in a binary file; at least 1 for a text
};

const std::map<std::string, ValueType>& ValueTypes()
{
  static const std::map<std::string, ValueType> types{{"bit", {Kind::Bit, 1}},
                                                      {"char", {Kind::Signed, 1}},
                                                      {"signed_char", {Kind::Signed, 1}},
                                                      {"unsigned_char", {Kind::Unsigned, 1}},
                                                      {"short", {Kind::Signed, 2}},
                                                      {"unsigned_short", {Kind::Unsigned, 2}},
                                                      {"int", {Kind::Signed, 4}},
                                                      {"unsigned_int", {Kind::Unsigned, 4}},
                                                      {"vtkidtype", {Kind::Signed, 4}},
                                                      {"long", {Kind::Signed, 8}},
                                                      {"unsigned_long", {Kind::Unsigned, 8}},
                                                      {"vtktypeint64", {Kind::Signed, 8}},
                                                      {"vtktypeuint64", {Kind::Unsigned, 8}},
                                                      {"float", {Kind::Real, 4}},
                                                      {"double", {Kind::Real, 8}},
                                                      {"string", {Kind::Text, 1}},
                                                      {"utf8_string", {Kind::Text, 1}}};
  return types;
}

// VTK's keywords may be in either case.
std::string InLowerCase(std::string_view word)
{
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return lower;
}

/// Parses a file from start to end.
class LegacyVtkText
{
public:
  LegacyVtkText(const std::string& bytes, const std::string& name) : Rest(bytes), FileName(name) {}

  vtkSmartPointer<vtkPolyData> Surface()
  {
    this->ReadHeader();
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    for (std::string section = this->Keyword();
         !section.empty() && section != "point_data" && section != "cell_data";
         section = this->Keyword())
    {
      this->ReadSection(section, surface);
    }
    if (surface->GetPoints() == nullptr)
    {
      this->Refuse("it has no points");
    }
    return surface;
  }

private:
  [[noreturn]] void Refuse(const std::string& fact) const
  {
    palpate::Refuse(this->FileName, "is not a readable legacy VTK surface: " + fact,
                    "write the file again");
  }

  std::string_view NextLine()
  {
    const std::string_view line = this->Rest.substr(0, this->Rest.find('\n'));
    this->Rest.remove_prefix(std::min(line.size() + 1, this->Rest.size()));
    return line;
  }

  // Empty at the end of the file.
  std::string_view NextWord()
  {
    this->Rest.remove_prefix(std::min(this->Rest.find_first_not_of(Blanks), this->Rest.size()));
    const std::string_view word = this->Rest.substr(0, this->Rest.find_first_of(Blanks));
    this->Rest.remove_prefix(word.size());
    return word;
  }
  std::string Keyword() { return InLowerCase(this->NextWord()); }

  void ReadHeader()
  {
    constexpr std::string_view Mark = "# vtk DataFile Version ";
    constexpr int LastVersion = 5;
    const std::string_view first = this->NextLine();
    const auto version = first.substr(0, Mark.size()) == Mark
                             ? ParseNumber(first.substr(Mark.size()))
                             : std::nullopt;
    if (!version || !(*version >= 1.0 && *version < LastVersion + 1))
    {
      this->Refuse("it does not start with \"# vtk DataFile Version\" 1 to 5");
    }
    this->HasOffsets = *version >= LastVersion;
    this->NextLine(); // the title
    const std::string coding = this->Keyword();
    this->IsText = coding == "ascii";
    if (!this->IsText && coding != "binary")
    {
      this->Refuse("it is neither ASCII nor BINARY");
    }
    if (this->Keyword() != "dataset" || this->Keyword() != "polydata")
    {
      this->Refuse("its data set is not POLYDATA");
    }
  }

  void ReadSection(const std::string& section, vtkPolyData* surface)
  {
    if (section == "metadata")
    {
      this->SkipMetaData();
    }
    else if (section == "field")
    {
      this->SkipField();
    }
    else
    {
      this->ReadGeometry(section, surface);
    }
  }

  void ReadGeometry(const std::string& section, vtkPolyData* surface)
  {
    if (!this->Seen.insert(section).second)
    {
      this->Refuse("it has two sections of the same kind");
    }
    if (section == "points")
    {
      surface->SetPoints(this->ReadPoints());
    }
    else if (section == "polygons")
    {
      surface->SetPolys(this->ReadCells(3));
    }
    else if (section == "triangle_strips")
    {
      surface->SetStrips(this->ReadCells(3));
    }
    else if (section == "vertices" || section == "lines")
    {
      this->ReadCells(0);
    }
    else
    {
      this->Refuse("it has a section that is not known");
    }
  }

  // Ends with an empty line.
  void SkipMetaData()
  {
    this->NextLine();
    while (!this->Rest.empty() && this->NextLine().find_first_not_of(Blanks) != std::string::npos)
    {
    }
  }

  void SkipField()
  {
    this->NextWord(); // its name
    const std::size_t arrays = this->Count();
    for (std::size_t array = 0; array < arrays; ++array)
    {
      std::string name = this->Keyword();
      if (name == "metadata")
      {
        this->SkipMetaData();
        name = this->Keyword();
      }
      if (name.empty())
      {
        this->Refuse("it ends too early");
      }
      if (name == "null_array")
      {
        continue;
      }
      const std::size_t components = this->Count();
      const std::size_t tuples = this->Count();
      this->SkipValues(this->TypeName(), components, tuples);
    }
  }

  void SkipValues(const ValueType& type, std::size_t components, std::size_t tuples)
  {
    // Each factor is below 2^31.
    const std::size_t count = components * tuples;
    if (type.Is == Kind::Text)
    {
      this->CheckRoom(count, 1);
      this->SkipTexts(count);
    }
    else if (this->IsText)
    {
      this->CheckRoom(count, 2);
      for (std::size_t i = 0; i < count; ++i)
      {
        this->NextNumber(type);
      }
    }
    else
    {
      const std::size_t items = type.Is == Kind::Bit ? (count + 7) / 8 : count;
      this->CheckRoom(items, type.Bytes);
      this->Rest.remove_prefix(items * type.Bytes);
    }
  }

  // A text per line, or in a binary file with its length before it.
  void SkipTexts(std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->IsText)
      {
        this->NextLine();
        continue;
      }
      // The first two bits tell the bytes of the length: 8, 4, 2 or 1.
      this->CheckRoom(1, 1);
      const int code = static_cast<unsigned char>(this->Rest.front()) >> 6;
      const std::size_t bytes = std::size_t{8} >> code;
      this->CheckRoom(1, bytes);
      const std::uint64_t length =
          this->TakeBits(bytes) & ((std::uint64_t{1} << (8 * bytes - 2)) - 1);
      this->CheckRoom(length, 1);
      this->Rest.remove_prefix(length);
    }
  }

  // A number of things, of which the file has to hold at least a bit each.
  std::size_t Count()
  {
    const auto number = ParseNumber(this->NextWord());
    if (!number || *number != std::floor(*number) ||
        !(*number >= 0.0 && *number <= 8.0 * static_cast<double>(this->Size)) ||
        *number > 2147483647.0)
    {
      this->Refuse("one of its counts is invalid");
    }
    return static_cast<std::size_t>(*number);
  }

  // A type, and the end of its line, after which binary values and texts begin.
  ValueType TypeName()
  {
    const auto found = ValueTypes().find(this->Keyword());
    if (found == ValueTypes().end())
    {
      this->Refuse("it has values of a type that is not supported");
    }
    if (!this->IsText || found->second.Is == Kind::Text)
    {
      this->NextLine();
    }
    return found->second;
  }

  void CheckRoom(std::size_t count, std::size_t bytes) const
  {
    // In a text, the last value needs no blank behind it.
    if (count > (this->Rest.size() + (this->IsText ? 1 : 0)) / bytes)
    {
      this->Refuse("it ends too early");
    }
  }

  std::uint64_t TakeBits(std::size_t bytes)
  {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < bytes; ++i)
    {
      bits = bits << 8 | static_cast<unsigned char>(this->Rest[i]); // big-endian
    }
    this->Rest.remove_prefix(bytes);
    return bits;
  }

  // The caller has checked that a binary file has room for it.
  double NextNumber(const ValueType& type)
  {
    if (this->IsText)
    {
      const auto number = ParseNumber(this->NextWord());
      if (!number)
      {
        this->Refuse(this->Rest.empty() ? "it ends too early" : "a number was expected");
      }
      return *number;
    }
    const std::uint64_t bits = this->TakeBits(type.Bytes);
    if (type.Is != Kind::Real)
    {
      const std::uint64_t sign = std::uint64_t{1} << (8 * type.Bytes - 1);
      const double value = static_cast<double>(bits & (sign - 1));
      const double top = static_cast<double>(bits & sign);
      return type.Is == Kind::Signed ? value - top : value + top;
    }
    if (type.Bytes == 4)
    {
      const auto low = static_cast<std::uint32_t>(bits);
      float value = 0.0F;
      std::memcpy(&value, &low, sizeof value);
      return value;
    }
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  ValueType NumberType()
  {
    const ValueType type = this->TypeName();
    if (type.Is == Kind::Text || type.Is == Kind::Bit)
    {
      this->Refuse("its points or cells are not numbers");
    }
    return type;
  }

  vtkSmartPointer<vtkPoints> ReadPoints()
  {
    const std::size_t count = this->Count();
    const ValueType type = this->NumberType();
    this->CheckRoom(3 * count, this->IsText ? 2 : type.Bytes);
    const bool isSingle = type.Bytes < (type.Is == Kind::Real ? 8 : 4);
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataType(isSingle ? VTK_FLOAT : VTK_DOUBLE);
    points->SetNumberOfPoints(static_cast<vtkIdType>(count));
    for (std::size_t i = 0; i < count; ++i)
    {
      double point[3];
      for (double& coordinate : point)
      {
        coordinate = this->NextNumber(type);
        if (!(std::abs(coordinate) <= std::numeric_limits<float>::max()))
        {
          this->Refuse("it has a point whose coordinates are not finite");
        }
      }
      points->SetPoint(static_cast<vtkIdType>(i), point);
    }
    return points;
  }

  vtkSmartPointer<vtkCellArray> ReadCells(std::size_t fewestCorners)
  {
    const std::size_t count = this->Count();
    const std::size_t size = this->Count();
    if (!this->HasOffsets && !this->IsText)
    {
      this->NextLine();
    }
    return this->HasOffsets ? this->CellsByOffsets(count, size, fewestCorners)
                            : this->CellsByCounts(count, size, fewestCorners);
  }

  // Before version 5: each cell is its number of corners and the corners, `size` numbers in all.
  vtkSmartPointer<vtkCellArray> CellsByCounts(std::size_t count, std::size_t size,
                                              std::size_t fewestCorners)
  {
    const ValueType type{Kind::Signed, 4};
    this->CheckRoom(size, this->IsText ? 2 : type.Bytes);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    std::size_t left = size;
    for (std::size_t cell = 0; cell < count; ++cell)
    {
      const double corners = left > 0 ? this->NextNumber(type) : -1.0;
      if (!(corners >= 0.0 && corners <= static_cast<double>(left - 1)) ||
          corners != std::floor(corners))
      {
        this->Refuse("its cells do not have their stated size");
      }
      left -= 1 + static_cast<std::size_t>(corners);
      this->TakeCell(type, static_cast<std::size_t>(corners), fewestCorners, cells);
    }
    if (left > 0)
    {
      this->Refuse("its cells do not have their stated size");
    }
    return cells;
  }

  // From version 5: where each cell's corners end, from 0, and the corners of all cells.
  vtkSmartPointer<vtkCellArray> CellsByOffsets(std::size_t offsetCount, std::size_t size,
                                               std::size_t fewestCorners)
  {
    this->Require("offsets");
    const ValueType offsetType = this->NumberType();
    this->CheckRoom(offsetCount, this->IsText ? 2 : offsetType.Bytes);
    std::vector<std::size_t> offsets(offsetCount);
    double last = 0.0;
    for (std::size_t& offset : offsets)
    {
      const double next = this->NextNumber(offsetType);
      if (!(next >= last && next <= static_cast<double>(size)) || next != std::floor(next))
      {
        this->Refuse("its cells do not have their stated size");
      }
      last = next;
      offset = static_cast<std::size_t>(next);
    }
    if (!offsets.empty() && (offsets.front() != 0 || offsets.back() != size))
    {
      this->Refuse("its cells do not have their stated size");
    }
    this->Require("connectivity");
    const ValueType type = this->NumberType();
    this->CheckRoom(size, this->IsText ? 2 : type.Bytes);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (std::size_t cell = 1; cell < offsets.size(); ++cell)
    {
      this->TakeCell(type, offsets[cell] - offsets[cell - 1], fewestCorners, cells);
    }
    return cells;
  }

  void Require(const char* keyword)
  {
    if (this->Keyword() != keyword)
    {
      this->Refuse(std::string("its cells lack their ") + keyword);
    }
  }

  void TakeCell(const ValueType& type, std::size_t count, std::size_t fewest, vtkCellArray* cells)
  {
    if (count < fewest)
    {
      this->Refuse("a polygon or strip has fewer than three corners");
    }
    this->Corners.resize(count);
    for (vtkIdType& corner : this->Corners)
    {
      const double index = this->NextNumber(type);
      if (!(index >= 0.0 && index <= 2147483647.0) || index != std::floor(index))
      {
        this->Refuse("a cell refers to a point that does not exist");
      }
      corner = static_cast<vtkIdType>(index);
    }
    if (fewest > 0) // others are skipped
    {
      cells->InsertNextCell(static_cast<vtkIdType>(count), this->Corners.data());
    }
  }

  std::string_view Rest;
  std::size_t Size = Rest.size();
  const std::string& FileName;
  bool IsText = true;
  bool HasOffsets = false;        // cells as of version 5
  std::set<std::string> Seen;     // sections
  std::vector<vtkIdType> Corners; // of the cell that is being read
};
} // namespace

vtkSmartPointer<vtkPolyData> SurfaceFromLegacyVtk(const std::string& bytes,
                                                  const std::string& fileName)
{
  return LegacyVtkText(bytes, fileName).Surface();
}

std::string TitleOfLegacyVtk(const std::string& bytes)
{
  const std::size_t first = bytes.find('\n');
  if (first == std::string::npos)
  {
    return {};
  }
  return bytes.substr(first + 1, bytes.find('\n', first + 1) - first - 1);
}
} // namespace palpate
