#include "ObjReader.h"

#include "DecimalText.h"
#include "Refusal.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace palpate
{
namespace
{
constexpr std::string_view ObjBlanks = " \t\r";

// Removes and returns the first word; empty at the end.
std::string_view TakeWord(std::string_view& rest)
{
  rest.remove_prefix(std::min(rest.find_first_not_of(ObjBlanks), rest.size()));
  const std::string_view word = rest.substr(0, rest.find_first_of(ObjBlanks));
  rest.remove_prefix(word.size());
  return word;
}

/// Parses a text line by line.
class ObjText
{
public:
  ObjText(std::string_view text, const std::string& name) : Rest(text), FileName(name) {}

  vtkSmartPointer<vtkPolyData> Surface()
  {
    while (!this->Rest.empty())
    {
      this->TakeLine(this->NextLine());
    }
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetData(AsArray(this->Points, ""));
    surface->SetPoints(points);
    surface->SetPolys(this->Faces);
    this->AddNormals(surface);
    return surface;
  }

private:
  using Triple = std::array<float, 3>;
  static constexpr vtkIdType None = -1;

  [[noreturn]] void Refuse(const std::string& fact) const
  {
    palpate::Refuse(this->FileName,
                    "is not a readable OBJ surface: " + fact + " in line " +
                        std::to_string(this->Line),
                    "write the file again");
  }

  // A line that ends with a backslash continues in the next.
  std::string NextLine()
  {
    std::string line;
    for (bool goesOn = true; goesOn && !this->Rest.empty();)
    {
      ++this->Line;
      std::string_view part = this->Rest.substr(0, this->Rest.find('\n'));
      this->Rest.remove_prefix(std::min(part.size() + 1, this->Rest.size()));
      part = part.substr(0, part.find_last_not_of(ObjBlanks) + 1);
      goesOn = !part.empty() && part.back() == '\\';
      part.remove_suffix(goesOn ? 1 : 0);
      line.append(part).append(goesOn ? " " : "");
    }
    return line;
  }

  void TakeLine(const std::string& line)
  {
    std::string_view words = line;
    const std::string_view keyword = TakeWord(words);
    if (keyword == "v")
    {
      this->Points.push_back(this->TakeTriple(words));
    }
    else if (keyword == "vn")
    {
      this->Normals.push_back(this->TakeTriple(words));
    }
    else if (keyword == "f")
    {
      this->TakeFace(words);
    }
  }

  // Further numbers (a weight, a colour) are ignored.
  Triple TakeTriple(std::string_view words) const
  {
    Triple triple{};
    for (float& number : triple)
    {
      const auto value = ParseNumber(TakeWord(words));
      if (!value || !(std::abs(*value) <= std::numeric_limits<float>::max()))
      {
        this->Refuse("three finite numbers were expected");
      }
      number = static_cast<float>(*value);
    }
    return triple;
  }

  void TakeFace(std::string_view words)
  {
    this->Corners.clear();
    for (std::string_view word = TakeWord(words); !word.empty(); word = TakeWord(words))
    {
      this->TakeCorner(word);
    }
    if (this->Corners.size() < 3)
    {
      this->Refuse("a face has fewer than three vertices");
    }
    this->Faces->InsertNextCell(static_cast<vtkIdType>(this->Corners.size()), this->Corners.data());
  }

  // "point", "point/texture", "point//normal" or "point/texture/normal".
  void TakeCorner(std::string_view word)
  {
    const std::size_t slash = word.find('/');
    const vtkIdType point = this->Index(word.substr(0, slash), this->Points.size());
    this->Corners.push_back(point);
    const std::size_t second = slash == std::string_view::npos ? slash : word.find('/', slash + 1);
    const bool hasNormal = second != std::string_view::npos && second + 1 < word.size();
    const vtkIdType normal =
        hasNormal ? this->Index(word.substr(second + 1), this->Normals.size()) : None;
    const auto place = static_cast<std::size_t>(point);
    // Points may follow the faces, but there cannot be more of them than the text has
    // characters.
    if (place >= this->NormalOfPoint.size())
    {
      this->NormalOfPoint.resize(place + 1, Unset);
    }
    vtkIdType& taken = this->NormalOfPoint[place];
    taken = taken == Unset || taken == normal ? normal : None;
    this->AllHaveNormals = this->AllHaveNormals && taken != None;
  }

  // Zero-based. In the file, indices count from 1, or backwards from the last element so far.
  vtkIdType Index(std::string_view word, std::size_t countSoFar) const
  {
    const auto number = ParseInteger(word);
    const vtkIdType index = !number       ? None
                            : *number > 0 ? vtkIdType{*number} - 1
                                          : static_cast<vtkIdType>(countSoFar) + *number;
    if (!number || *number == 0 || index < 0 || static_cast<std::size_t>(index) > this->TextSize)
    {
      this->Refuse("a face refers to a point or normal that does not exist");
    }
    return index;
  }

  void AddNormals(vtkPolyData* surface) const
  {
    bool areThere = this->AllHaveNormals && this->NormalOfPoint.size() == this->Points.size();
    std::vector<Triple> normals;
    for (const vtkIdType normal : this->NormalOfPoint)
    {
      areThere = areThere && normal >= 0 && normal < static_cast<vtkIdType>(this->Normals.size());
      if (!areThere)
      {
        return;
      }
      normals.push_back(this->Normals[static_cast<std::size_t>(normal)]);
    }
    if (areThere && !normals.empty())
    {
      surface->GetPointData()->SetNormals(AsArray(normals, "Normals"));
    }
  }

  static vtkSmartPointer<vtkFloatArray> AsArray(const std::vector<Triple>& triples,
                                                const char* name)
  {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(triples.size()));
    for (std::size_t i = 0; i < triples.size(); ++i)
    {
      array->SetTypedTuple(static_cast<vtkIdType>(i), triples[i].data());
    }
    return array;
  }

  static constexpr vtkIdType Unset = -2;

  std::string_view Rest;
  std::size_t TextSize = Rest.size();
  const std::string& FileName;
  std::size_t Line = 0;
  std::vector<Triple> Points;
  std::vector<Triple> Normals;
  std::vector<vtkIdType> Corners; // of the face that is being read
  vtkNew<vtkCellArray> Faces;
  std::vector<vtkIdType> NormalOfPoint; // an index of Normals, None or Unset
  bool AllHaveNormals = true;
};
} // namespace

vtkSmartPointer<vtkPolyData> SurfaceFromObj(const std::string& text, const std::string& fileName)
{
  return ObjText(text, fileName).Surface();
}
} // namespace palpate
