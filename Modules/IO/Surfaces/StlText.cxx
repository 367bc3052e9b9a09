#include "StlText.h"

#include "Refusal.h"

#include "vtkCellArray.h"
#include "vtkMergePoints.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace palpate
{
namespace
{
/// The words of a text, one after the other.
class StlWords
{
public:
  explicit StlWords(const std::string& text) : Left(text) {}

  /// Empty at the end.
  std::string_view Next()
  {
    constexpr const char* Separators = " \t\r\n\v\f";
    this->Left.remove_prefix(std::min(this->Left.find_first_not_of(Separators), this->Left.size()));
    const std::size_t length = std::min(this->Left.find_first_of(Separators), this->Left.size());
    const std::string_view word = this->Left.substr(0, length);
    this->Left.remove_prefix(length);
    return word;
  }

  void SkipLine()
  {
    this->Left.remove_prefix(std::min(this->Left.find_first_of("\r\n"), this->Left.size()));
  }

private:
  std::string_view Left;
};

bool IsStlWord(std::string_view word, std::string_view lowerCase)
{
  return word.size() == lowerCase.size() &&
         std::equal(word.begin(), word.end(), lowerCase.begin(),
                    [](unsigned char a, char b) { return std::tolower(a) == b; });
}

// In any case.
bool MentionsWord(const std::string& text, std::string_view lowerCase)
{
  return std::search(text.begin(), text.end(), lowerCase.begin(), lowerCase.end(),
                     [](unsigned char a, char b) { return std::tolower(a) == b; }) != text.end();
}

[[noreturn]] void RefuseStl(const std::string& file, const std::string& fact)
{
  Refuse(file, fact, "write the file again");
}

void ReadStlVertex(StlWords& words, const std::string& file, vtkPoints* points)
{
  std::array<float, 3> place{};
  for (float& coordinate : place)
  {
    std::string_view word = words.Next();
    word.remove_prefix(word.rfind('+', 0) == 0 ? 1 : 0);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), coordinate);
    if (error != std::errc() || end != word.data() + word.size())
    {
      RefuseStl(file, "is not a complete STL file: a vertex is not three numbers");
    }
  }
  points->InsertNextPoint(place.data());
}

// Three of each triangle.
vtkSmartPointer<vtkPoints> ReadStlCorners(const std::string& text, const std::string& file)
{
  auto corners = vtkSmartPointer<vtkPoints>::New();
  StlWords words(text);
  bool isClosed = false;
  for (std::string_view word = words.Next(); !word.empty(); word = words.Next())
  {
    if (IsStlWord(word, "solid") || IsStlWord(word, "endsolid"))
    {
      isClosed = IsStlWord(word, "endsolid");
      words.SkipLine(); // its name, of any length and words
    }
    else if (IsStlWord(word, "vertex"))
    {
      ReadStlVertex(words, file, corners);
    }
    else if (IsStlWord(word, "endloop") && corners->GetNumberOfPoints() % 3 != 0)
    {
      RefuseStl(file, "has a facet that is not a triangle");
    }
  }
  if (!isClosed || corners->GetNumberOfPoints() % 3 != 0 || corners->GetNumberOfPoints() == 0)
  {
    RefuseStl(file, "is not a complete STL file (it may be truncated)");
  }
  return corners;
}
} // namespace

bool IsStlText(const std::string& bytes)
{
  constexpr std::size_t Header = 80;
  constexpr std::size_t Triangle = 50;
  std::uint64_t triangles = 0;
  for (std::size_t i = 4; i-- > 0 && bytes.size() >= Header + 4;)
  {
    triangles = triangles << 8 | static_cast<unsigned char>(bytes[Header + i]);
  }
  return IsStlWord(std::string_view(bytes).substr(0, 5), "solid") &&
         bytes.size() != Header + 4 + Triangle * triangles &&
         (MentionsWord(bytes, "facet") || MentionsWord(bytes, "endsolid"));
}

vtkSmartPointer<vtkPolyData> SurfaceFromStlText(const std::string& text, const std::string& file)
{
  const vtkSmartPointer<vtkPoints> corners = ReadStlCorners(text, file);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkMergePoints> locator;
  locator->InitPointInsertion(points, corners->GetBounds());
  for (vtkIdType corner = 0; corner < corners->GetNumberOfPoints(); corner += 3)
  {
    std::array<vtkIdType, 3> ids{};
    for (vtkIdType i = 0; i < 3; ++i)
    {
      locator->InsertUniquePoint(corners->GetPoint(corner + i), ids[static_cast<std::size_t>(i)]);
    }
    if (ids[0] != ids[1] && ids[0] != ids[2] && ids[1] != ids[2])
    {
      triangles->InsertNextCell(3, ids.data());
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}
} // namespace palpate
