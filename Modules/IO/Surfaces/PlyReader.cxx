#include "PlyReader.h"

#include "DecimalText.h"
#include "Refusal.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string_view>

namespace palpate
{
namespace
{
enum class Encoding
{
  Text,
  LittleEndian,
  BigEndian
};

struct NumberType
{
  std::size_t Bytes;
  bool Signed;
  bool Real;
};

struct Property
{
  std::string Name;
  NumberType Type;
  bool IsList;
  NumberType CountType; ///< of a list
};

struct Element
{
  std::string Name;
  std::size_t Count;
  std::vector<Property> Properties;
};

const std::map<std::string, NumberType>& NumberTypes()
{
  static const std::map<std::string, NumberType> types{
      {"char", {1, true, false}},    {"int8", {1, true, false}},    {"uchar", {1, false, false}},
      {"uint8", {1, false, false}},  {"short", {2, true, false}},   {"int16", {2, true, false}},
      {"ushort", {2, false, false}}, {"uint16", {2, false, false}}, {"int", {4, true, false}},
      {"int32", {4, true, false}},   {"uint", {4, false, false}},   {"uint32", {4, false, false}},
      {"float", {4, true, true}},    {"float32", {4, true, true}},  {"double", {8, true, true}},
      {"float64", {8, true, true}}};
  return types;
}

// Each element is compared with all before it; real files have a handful.
constexpr std::size_t MostElements = 256;

/// Parses a file from start to end.
class PlyText
{
public:
  PlyText(const std::string& bytes, const std::string& name) : Rest(bytes), FileName(name) {}

  TriangleMesh Mesh()
  {
    this->ReadHeader();
    TriangleMesh mesh;
    for (const Element& element : this->Elements)
    {
      this->CheckCount(element);
      if (element.Name == "vertex")
      {
        this->ReadVertices(element, mesh);
      }
      else
      {
        this->ReadOthers(element, mesh);
      }
    }
    return mesh;
  }

private:
  [[noreturn]] void Refuse(const std::string& fact) const
  {
    palpate::Refuse(this->FileName, "is not a readable PLY surface: " + fact,
                    "write the file again");
  }

  std::string HeaderLine()
  {
    const std::size_t end = this->Rest.find('\n');
    if (end == std::string_view::npos)
    {
      this->Refuse("its header does not end");
    }
    std::string line(this->Rest.substr(0, end));
    this->Rest.remove_prefix(end + 1);
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    return line;
  }

  void ReadHeader()
  {
    if (this->HeaderLine() != "ply")
    {
      this->Refuse("it does not start with \"ply\"");
    }
    for (std::string line = this->HeaderLine(); line != "end_header"; line = this->HeaderLine())
    {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "format")
      {
        this->TakeFormat(words);
      }
      else if (keyword == "element")
      {
        this->TakeElement(words);
      }
      else if (keyword == "property")
      {
        this->TakeProperty(words);
      }
    }
  }

  void TakeFormat(std::istringstream& words)
  {
    std::string name;
    words >> name;
    if (name == "ascii")
    {
      this->Coding = Encoding::Text;
    }
    else if (name == "binary_little_endian")
    {
      this->Coding = Encoding::LittleEndian;
    }
    else if (name == "binary_big_endian")
    {
      this->Coding = Encoding::BigEndian;
    }
    else
    {
      this->Refuse("its format is unknown");
    }
  }

  void TakeElement(std::istringstream& words)
  {
    Element element;
    if (!(words >> element.Name >> element.Count))
    {
      this->Refuse("an element in its header has no count");
    }
    if (this->Elements.size() == MostElements)
    {
      this->Refuse("it has more than " + std::to_string(MostElements) + " elements");
    }
    const auto isSame = [&](const Element& other) { return other.Name == element.Name; };
    if (std::any_of(this->Elements.begin(), this->Elements.end(), isSame))
    {
      this->Refuse("an element is declared twice in its header");
    }
    this->Elements.push_back(std::move(element));
  }

  NumberType TakeType(std::istringstream& words) const
  {
    std::string name;
    words >> name;
    const auto found = NumberTypes().find(name);
    if (found == NumberTypes().end())
    {
      this->Refuse("a property in its header has an unknown type");
    }
    return found->second;
  }

  void TakeProperty(std::istringstream& words)
  {
    if (this->Elements.empty())
    {
      this->Refuse("a property in its header belongs to no element");
    }
    Property property{};
    const std::istringstream::pos_type start = words.tellg();
    std::string first;
    words >> first;
    property.IsList = first == "list";
    if (property.IsList)
    {
      property.CountType = this->TakeType(words);
    }
    else
    {
      words.seekg(start);
    }
    property.Type = this->TakeType(words);
    words >> property.Name;
    this->Elements.back().Properties.push_back(std::move(property));
  }

  // Called before memory is reserved, since a damaged header may declare any count.
  void CheckCount(const Element& element) const
  {
    std::size_t least = 0;
    for (const Property& property : element.Properties)
    {
      least += this->Coding == Encoding::Text ? 1
               : property.IsList              ? property.CountType.Bytes
                                              : property.Type.Bytes;
    }
    if (element.Count > 0 && (least == 0 || element.Count > this->Rest.size() / least + 1))
    {
      this->Refuse("it ends too early");
    }
  }

  double NextNumber(const NumberType& type)
  {
    return this->Coding == Encoding::Text ? this->NextWord() : this->NextBinary(type);
  }

  double NextWord()
  {
    const char* blanks = " \t\r\n";
    this->Rest.remove_prefix(std::min(this->Rest.find_first_not_of(blanks), this->Rest.size()));
    const std::string_view word = this->Rest.substr(0, this->Rest.find_first_of(blanks));
    this->Rest.remove_prefix(word.size());
    const std::optional<double> value = ParseNumber(word);
    if (!value)
    {
      this->Refuse(word.empty() ? "it ends too early"
                                : "it holds a value that is not a finite number");
    }
    return *value;
  }

  double NextBinary(const NumberType& type)
  {
    if (this->Rest.size() < type.Bytes)
    {
      this->Refuse("it ends too early");
    }
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.Bytes; ++i)
    {
      const std::size_t from = this->Coding == Encoding::BigEndian ? i : type.Bytes - 1 - i;
      bits = bits << 8 | static_cast<unsigned char>(this->Rest[from]);
    }
    this->Rest.remove_prefix(type.Bytes);
    return Decoded(bits, type);
  }

  static double Decoded(std::uint64_t bits, const NumberType& type)
  {
    if (type.Real && type.Bytes == sizeof(double))
    {
      double value = 0.0;
      std::memcpy(&value, &bits, sizeof value);
      return value;
    }
    if (type.Real)
    {
      const auto low = static_cast<std::uint32_t>(bits);
      float value = 0.0f;
      std::memcpy(&value, &low, sizeof value);
      return value;
    }
    const std::uint64_t signBit = std::uint64_t{1} << (8 * type.Bytes - 1);
    const double value = static_cast<double>(bits);
    return type.Signed && (bits & signBit) != 0 ? value - 2.0 * static_cast<double>(signBit)
                                                : value;
  }

  std::vector<double> NextList(const Property& property)
  {
    const double count = this->NextNumber(property.CountType);
    const std::size_t least = this->Coding == Encoding::Text ? 1 : property.Type.Bytes;
    if (!(count >= 0.0 && count <= static_cast<double>(this->Rest.size() / least + 1)) ||
        count != std::floor(count))
    {
      this->Refuse("it ends too early");
    }
    std::vector<double> values(static_cast<std::size_t>(count));
    for (double& value : values)
    {
      value = this->NextNumber(property.Type);
    }
    return values;
  }

  void ReadVertices(const Element& element, TriangleMesh& mesh)
  {
    std::map<std::string, std::vector<double>> columns;
    for (std::size_t i = 0; i < element.Count; ++i)
    {
      for (const Property& property : element.Properties)
      {
        if (property.IsList)
        {
          this->NextList(property);
        }
        else
        {
          columns[property.Name].push_back(this->NextNumber(property.Type));
        }
      }
    }
    const auto isDouble = [](const Property& p) { return p.Name == "x" && p.Type.Bytes == 8; };
    mesh.SinglePrecision =
        this->Coding != Encoding::Text &&
        std::none_of(element.Properties.begin(), element.Properties.end(), isDouble);
    mesh.PointsWorld = TakeVectors(columns, {"x", "y", "z"});
    mesh.Normals = TakeVectors(columns, {"nx", "ny", "nz"});
    for (const Vector3& color : TakeVectors(columns, {"red", "green", "blue"}))
    {
      mesh.Colors.push_back({AsByte(color.x()), AsByte(color.y()), AsByte(color.z())});
    }
    for (auto& [name, numbers] : columns)
    {
      if (numbers.size() == element.Count)
      {
        mesh.Values.push_back({name, std::move(numbers)});
      }
    }
  }

  static unsigned char AsByte(double value)
  {
    // NaN, which binary files may hold, becomes 0.
    return static_cast<unsigned char>(value > 0.0 ? std::min(value, 255.0) : 0.0);
  }

  // Moves three columns out as vectors; empty if one of them is missing.
  static std::vector<Vector3> TakeVectors(std::map<std::string, std::vector<double>>& columns,
                                          const std::array<std::string, 3>& names)
  {
    std::vector<Vector3> vectors;
    const auto& x = columns[names[0]];
    const auto& y = columns[names[1]];
    const auto& z = columns[names[2]];
    if (x.size() == y.size() && y.size() == z.size())
    {
      for (std::size_t i = 0; i < x.size(); ++i)
      {
        vectors.emplace_back(x[i], y[i], z[i]);
      }
    }
    for (const std::string& name : names)
    {
      columns.erase(name);
    }
    return vectors;
  }

  void ReadOthers(const Element& element, TriangleMesh& mesh)
  {
    for (std::size_t i = 0; i < element.Count; ++i)
    {
      for (const Property& property : element.Properties)
      {
        if (!property.IsList)
        {
          this->NextNumber(property.Type);
          continue;
        }
        const std::vector<double> corners = this->NextList(property);
        const bool isFace = element.Name == "face" &&
                            (property.Name == "vertex_indices" || property.Name == "vertex_index");
        for (std::size_t k = 2; isFace && k < corners.size(); ++k)
        {
          mesh.Triangles.push_back(
              {this->Corner(corners[0]), this->Corner(corners[k - 1]), this->Corner(corners[k])});
        }
      }
    }
  }

  int Corner(double index) const
  {
    if (!(index >= 0.0 && index <= 2147483647.0) || index != std::floor(index))
    {
      this->Refuse("a face refers to a point that does not exist");
    }
    return static_cast<int>(index);
  }

  std::string_view Rest;
  const std::string& FileName;
  Encoding Coding = Encoding::Text;
  std::vector<Element> Elements;
};
} // namespace

TriangleMesh MeshFromPly(const std::string& bytes, const std::string& fileName)
{
  return PlyText(bytes, fileName).Mesh();
}
} // namespace palpate
