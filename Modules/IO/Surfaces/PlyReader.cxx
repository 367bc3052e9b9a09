#include "PlyReader.h"

#include "SurfaceBytes.h"

#include <algorithm>
#include <map>

namespace palpate
{
namespace
{
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

using PlyTypeTable = std::map<std::string, NumberType, std::less<>>;
const PlyTypeTable& PlyTypes()
{
  static const PlyTypeTable types{
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
class PlyFile
{
public:
  PlyFile(const std::string& bytes, const std::string& name) : File(bytes, name, "PLY") {}

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
  std::string_view HeaderLine()
  {
    if (this->File.IsEmpty())
    {
      this->File.Refuse("its header does not end");
    }
    return this->File.Line();
  }

  void ReadHeader()
  {
    if (this->HeaderLine() != "ply")
    {
      this->File.Refuse("it does not start with \"ply\"");
    }
    for (std::string_view line = this->HeaderLine(); line != "end_header";
         line = this->HeaderLine())
    {
      const std::string_view keyword = TakeWord(line);
      if (keyword == "format")
      {
        this->File.Coding = this->CodingNamed(TakeWord(line));
      }
      else if (keyword == "element")
      {
        this->TakeElement(line);
      }
      else if (keyword == "property")
      {
        this->TakeProperty(line);
      }
    }
  }

  NumberCoding CodingNamed(std::string_view name) const
  {
    if (name != "ascii" && name != "binary_little_endian" && name != "binary_big_endian")
    {
      this->File.Refuse("its format is unknown");
    }
    return name == "ascii"               ? NumberCoding::Text
           : name == "binary_big_endian" ? NumberCoding::BigEndian
                                         : NumberCoding::LittleEndian;
  }

  void TakeElement(std::string_view words)
  {
    Element element;
    element.Name = TakeWord(words);
    element.Count = this->File.CountOf(TakeWord(words));
    if (this->Elements.size() == MostElements)
    {
      this->File.Refuse("it has more than " + std::to_string(MostElements) + " elements");
    }
    const auto isSame = [&](const Element& other) { return other.Name == element.Name; };
    if (std::any_of(this->Elements.begin(), this->Elements.end(), isSame))
    {
      this->File.Refuse("an element is declared twice in its header");
    }
    this->Elements.push_back(std::move(element));
  }

  NumberType TypeNamed(std::string_view name) const
  {
    const auto found = PlyTypes().find(name);
    if (found == PlyTypes().end())
    {
      this->File.Refuse("a property in its header has an unknown type");
    }
    return found->second;
  }

  void TakeProperty(std::string_view words)
  {
    if (this->Elements.empty())
    {
      this->File.Refuse("a property in its header belongs to no element");
    }
    Property property{};
    std::string_view type = TakeWord(words);
    property.IsList = type == "list";
    if (property.IsList)
    {
      property.CountType = this->TypeNamed(TakeWord(words));
      type = TakeWord(words);
    }
    property.Type = this->TypeNamed(type);
    property.Name = TakeWord(words);
    this->Elements.back().Properties.push_back(std::move(property));
  }

  // A damaged header may declare any count.
  void CheckCount(const Element& element) const
  {
    std::size_t least = 0;
    for (const Property& property : element.Properties)
    {
      least += this->File.LeastBytes(property.IsList ? property.CountType : property.Type);
    }
    this->File.RequireRoom(element.Count, least);
  }

  std::vector<double> NextList(const Property& property)
  {
    const std::size_t count = this->File.CountOf(this->File.Number(property.CountType));
    this->File.RequireRoom(count, this->File.LeastBytes(property.Type));
    std::vector<double> values(count);
    for (double& value : values)
    {
      value = this->File.Number(property.Type);
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
          columns[property.Name].push_back(this->File.Number(property.Type));
        }
      }
    }
    const auto isDouble = [](const Property& p) { return p.Name == "x" && p.Type.Bytes == 8; };
    mesh.SinglePrecision = !this->File.IsText() && std::none_of(element.Properties.begin(),
                                                                element.Properties.end(), isDouble);
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
          this->File.Number(property.Type);
          continue;
        }
        const std::vector<double> corners = this->NextList(property);
        const bool isFace = element.Name == "face" &&
                            (property.Name == "vertex_indices" || property.Name == "vertex_index");
        for (std::size_t k = 2; isFace && k < corners.size(); ++k)
        {
          mesh.Triangles.push_back({this->File.IndexOf(corners[0]),
                                    this->File.IndexOf(corners[k - 1]),
                                    this->File.IndexOf(corners[k])});
        }
      }
    }
  }

  SurfaceBytes File;
  std::vector<Element> Elements;
};
} // namespace

TriangleMesh MeshFromPly(const std::string& bytes, const std::string& fileName)
{
  return PlyFile(bytes, fileName).Mesh();
}
} // namespace palpate
