#include "ObjReader.h"

#include "DecimalText.h"
#include "SurfaceBytes.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

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
/// Parses a text line by line.
class ObjText
{
public:
  ObjText(std::string_view text, const std::string& name) : File(text, name, "OBJ")
  {
    this->Normals->SetNumberOfComponents(3);
  }

  vtkSmartPointer<vtkPolyData> Surface()
  {
    while (!this->File.IsEmpty())
    {
      this->TakeLine(this->NextLine());
    }
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(this->Points);
    surface->SetPolys(this->Faces);
    this->AddNormals(surface);
    return surface;
  }

private:
  using Triple = std::array<float, 3>;
  static constexpr vtkIdType None = -1;

  [[noreturn]] void Refuse(const std::string& fact) const
  {
    this->File.Refuse(fact + " in line " + std::to_string(this->Line));
  }

  // A line that ends with a backslash continues in the next.
  std::string NextLine()
  {
    std::string line;
    for (bool goesOn = true; goesOn && !this->File.IsEmpty();)
    {
      ++this->Line;
      std::string_view part = this->File.Line();
      part = part.substr(0, part.find_last_not_of(" \t\r") + 1);
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
      this->Points->InsertNextPoint(this->TakeTriple(words).data());
    }
    else if (keyword == "vn")
    {
      this->Normals->InsertNextTypedTuple(this->TakeTriple(words).data());
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
    const vtkIdType point = this->Index(word.substr(0, slash), this->Points->GetNumberOfPoints());
    this->Corners.push_back(point);
    const std::size_t second = slash == std::string_view::npos ? slash : word.find('/', slash + 1);
    const bool hasNormal = second != std::string_view::npos && second + 1 < word.size();
    const vtkIdType normal =
        hasNormal ? this->Index(word.substr(second + 1), this->Normals->GetNumberOfTuples()) : None;
    const auto place = static_cast<std::size_t>(point);
    // Points may follow the faces, but there cannot be more of them than the text has
    // characters.
    if (place >= this->NormalOfPoint.size())
    {
      this->NormalOfPoint.resize(place + 1, Unset);
    }
    vtkIdType& taken = this->NormalOfPoint[place];
    taken = taken == Unset || taken == normal ? normal : None;
  }

  // Zero-based. In the file, indices count from 1, or backwards from the last element so far.
  vtkIdType Index(std::string_view word, vtkIdType countSoFar) const
  {
    const auto number = ParseInteger(word);
    const vtkIdType index = !number       ? None
                            : *number > 0 ? vtkIdType{*number} - 1
                                          : countSoFar + *number;
    if (!number || *number == 0 || index < 0 || static_cast<std::size_t>(index) > this->File.Size())
    {
      this->Refuse("a face refers to a point or normal that does not exist");
    }
    return index;
  }

  // If every point has one.
  void AddNormals(vtkPolyData* surface) const
  {
    const auto isThere = [count = this->Normals->GetNumberOfTuples()](vtkIdType normal)
    { return normal >= 0 && normal < count; };
    const std::vector<vtkIdType>& chosen = this->NormalOfPoint;
    if (chosen.empty() ||
        chosen.size() != static_cast<std::size_t>(this->Points->GetNumberOfPoints()) ||
        !std::all_of(chosen.begin(), chosen.end(), isThere))
    {
      return;
    }
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (const vtkIdType normal : chosen)
    {
      normals->InsertNextTuple(normal, this->Normals);
    }
    surface->GetPointData()->SetNormals(normals);
  }

  static constexpr vtkIdType Unset = -2;

  SurfaceBytes File;
  std::size_t Line = 0;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
  std::vector<vtkIdType> Corners; // of the face that is being read
  vtkNew<vtkCellArray> Faces;
  std::vector<vtkIdType> NormalOfPoint; // an index of Normals, None or Unset
};
} // namespace

vtkSmartPointer<vtkPolyData> SurfaceFromObj(const std::string& text, const std::string& fileName)
{
  return ObjText(text, fileName).Surface();
}
} // namespace palpate
