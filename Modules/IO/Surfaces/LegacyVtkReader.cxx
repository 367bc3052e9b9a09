#include "LegacyVtkReader.h"

#include "DecimalText.h"
#include "SurfaceBytes.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace palpate
{
namespace
{
const std::map<std::string, NumberType>& VtkTypes()
{
  static const std::map<std::string, NumberType> types{{"char", {1, true, false}},
                                                       {"signed_char", {1, true, false}},
                                                       {"unsigned_char", {1, false, false}},
                                                       {"short", {2, true, false}},
                                                       {"unsigned_short", {2, false, false}},
                                                       {"int", {4, true, false}},
                                                       {"unsigned_int", {4, false, false}},
                                                       {"vtkidtype", {4, true, false}},
                                                       {"long", {8, true, false}},
                                                       {"unsigned_long", {8, false, false}},
                                                       {"vtktypeint64", {8, true, false}},
                                                       {"vtktypeuint64", {8, false, false}},
                                                       {"float", {4, true, true}},
                                                       {"double", {8, true, true}}};
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
class LegacyVtkFile
{
public:
  LegacyVtkFile(const std::string& bytes, const std::string& name) : File(bytes, name, "legacy VTK")
  {
  }

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
      this->File.Refuse("it has no points");
    }
    return surface;
  }

private:
  // Empty at the end of the file.
  std::string Keyword() { return InLowerCase(this->File.Word()); }
  std::size_t Count() { return this->File.CountOf(this->File.Word()); }

  void ReadHeader()
  {
    constexpr std::string_view Mark = "# vtk DataFile Version ";
    constexpr int LastVersion = 5;
    const std::string_view first = this->File.Line();
    const auto version = first.substr(0, Mark.size()) == Mark
                             ? ParseNumber(first.substr(Mark.size()))
                             : std::nullopt;
    if (!version || !(*version >= 1.0 && *version < LastVersion + 1))
    {
      this->File.Refuse("it does not start with \"# vtk DataFile Version\" 1 to 5");
    }
    this->HasOffsets = *version >= LastVersion;
    this->File.Line(); // the title
    const std::string coding = this->Keyword();
    this->File.Coding = coding == "binary" ? NumberCoding::BigEndian : NumberCoding::Text;
    if (coding != "ascii" && coding != "binary")
    {
      this->File.Refuse("it is neither ASCII nor BINARY");
    }
    if (this->Keyword() != "dataset" || this->Keyword() != "polydata")
    {
      this->File.Refuse("its data set is not POLYDATA");
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
      this->File.Refuse("it has two sections of the same kind");
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
      this->File.Refuse("it has a section that is not known");
    }
  }

  // Ends with an empty line.
  void SkipMetaData()
  {
    this->File.Line();
    std::string_view line;
    do
    {
      line = this->File.Line();
    } while (!TakeWord(line).empty());
  }

  void SkipField()
  {
    this->File.Word(); // its name
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
        this->File.Refuse("it ends too early");
      }
      if (name != "null_array")
      {
        // Each factor is below 2^31.
        const std::size_t components = this->Count();
        this->SkipValues(components * this->Count());
      }
    }
  }

  void SkipValues(std::size_t count)
  {
    const std::string type = this->Keyword();
    if (type == "string" || type == "utf8_string")
    {
      this->File.Line();
      this->File.RequireRoom(count, 1);
      this->SkipTexts(count);
      return;
    }
    const bool areBits = type == "bit";
    const NumberType number = areBits ? NumberType{1, false, false} : this->TypeNamed(type);
    const std::size_t items = areBits && !this->File.IsText() ? (count + 7) / 8 : count;
    this->File.RequireRoom(items, this->File.LeastBytes(number));
    if (!this->File.IsText())
    {
      this->File.Line();
      this->File.Bytes(items * number.Bytes);
      return;
    }
    for (std::size_t i = 0; i < items; ++i)
    {
      this->File.Number(number);
    }
  }

  // A text per line, or in a binary file with its length before it.
  void SkipTexts(std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->File.IsText())
      {
        this->File.Line();
        continue;
      }
      // The first two bits tell the bytes of the length: 8, 4, 2 or 1.
      const auto first = static_cast<unsigned char>(this->File.Bytes(1).front());
      const std::size_t more = (std::size_t{8} >> (first >> 6)) - 1;
      const std::uint64_t high = std::uint64_t{first & 63U} << (8 * more);
      this->File.Bytes(high | BitsOf(this->File.Bytes(more), NumberCoding::BigEndian));
    }
  }

  NumberType TypeNamed(const std::string& name) const
  {
    const auto found = VtkTypes().find(name);
    if (found == VtkTypes().end())
    {
      this->File.Refuse("some of its values are not numbers of a known type");
    }
    return found->second;
  }

  // Of points or cells; binary values begin in the next line.
  NumberType TakeType()
  {
    const NumberType type = this->TypeNamed(this->Keyword());
    if (!this->File.IsText())
    {
      this->File.Line();
    }
    return type;
  }

  vtkSmartPointer<vtkPoints> ReadPoints()
  {
    const std::size_t count = this->Count();
    const NumberType type = this->TakeType();
    this->File.RequireRoom(3 * count, this->File.LeastBytes(type));
    const bool isSingle = type.Bytes < (type.Real ? 8 : 4);
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataType(isSingle ? VTK_FLOAT : VTK_DOUBLE);
    points->SetNumberOfPoints(static_cast<vtkIdType>(count));
    for (std::size_t i = 0; i < count; ++i)
    {
      double point[3];
      for (double& coordinate : point)
      {
        coordinate = this->File.Number(type);
        if (!(std::abs(coordinate) <= std::numeric_limits<float>::max()))
        {
          this->File.Refuse("it has a point whose coordinates are not finite");
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
    if (!this->HasOffsets && !this->File.IsText())
    {
      this->File.Line();
    }
    return this->HasOffsets ? this->CellsByOffsets(count, size, fewestCorners)
                            : this->CellsByCounts(count, size, fewestCorners);
  }

  // Before version 5: each cell is its number of corners and the corners, `size` numbers in all.
  vtkSmartPointer<vtkCellArray> CellsByCounts(std::size_t count, std::size_t size,
                                              std::size_t fewestCorners)
  {
    const NumberType type{4, true, false};
    this->File.RequireRoom(size, this->File.LeastBytes(type));
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    std::size_t left = size;
    for (std::size_t cell = 0; cell < count; ++cell)
    {
      const double corners = left > 0 ? this->File.Number(type) : -1.0;
      if (!(corners >= 0.0 && corners <= static_cast<double>(left - 1)) ||
          corners != std::floor(corners))
      {
        this->File.Refuse("its cells do not have their stated size");
      }
      left -= 1 + static_cast<std::size_t>(corners);
      this->TakeCell(type, static_cast<std::size_t>(corners), fewestCorners, cells);
    }
    if (left > 0)
    {
      this->File.Refuse("its cells do not have their stated size");
    }
    return cells;
  }

  // From version 5: where each cell's corners end, from 0, and the corners of all cells.
  vtkSmartPointer<vtkCellArray> CellsByOffsets(std::size_t offsetCount, std::size_t size,
                                               std::size_t fewestCorners)
  {
    this->Require("offsets");
    const NumberType offsetType = this->TakeType();
    this->File.RequireRoom(offsetCount, this->File.LeastBytes(offsetType));
    std::vector<std::size_t> offsets(offsetCount);
    double last = 0.0;
    for (std::size_t& offset : offsets)
    {
      const double next = this->File.Number(offsetType);
      if (!(next >= last && next <= static_cast<double>(size)) || next != std::floor(next))
      {
        this->File.Refuse("its cells do not have their stated size");
      }
      last = next;
      offset = static_cast<std::size_t>(next);
    }
    if (!offsets.empty() && (offsets.front() != 0 || offsets.back() != size))
    {
      this->File.Refuse("its cells do not have their stated size");
    }
    this->Require("connectivity");
    const NumberType type = this->TakeType();
    this->File.RequireRoom(size, this->File.LeastBytes(type));
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
      this->File.Refuse(std::string("its cells lack their ") + keyword);
    }
  }

  void TakeCell(const NumberType& type, std::size_t count, std::size_t fewest, vtkCellArray* cells)
  {
    if (count < fewest)
    {
      this->File.Refuse("a polygon or strip has fewer than three corners");
    }
    this->Corners.resize(count);
    for (vtkIdType& corner : this->Corners)
    {
      corner = this->File.IndexOf(this->File.Number(type));
    }
    if (fewest > 0) // others are skipped
    {
      cells->InsertNextCell(static_cast<vtkIdType>(count), this->Corners.data());
    }
  }

  SurfaceBytes File;
  bool HasOffsets = false;        // cells as of version 5
  std::set<std::string> Seen;     // sections
  std::vector<vtkIdType> Corners; // of the cell that is being read
};
} // namespace

vtkSmartPointer<vtkPolyData> SurfaceFromLegacyVtk(const std::string& bytes,
                                                  const std::string& fileName)
{
  return LegacyVtkFile(bytes, fileName).Surface();
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
