#include "SurfaceSpace.h"

#include "Refusal.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <cctype>
#include <string>

namespace palpate
{
namespace
{
constexpr std::string_view Tag = "SPACE=";

bool IsWordLetter(char letter)
{
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '-';
}

SurfaceSpace SpaceNamed(const std::filesystem::path& file, std::string_view name)
{
  if (name != "LPS" && name != "RAS")
  {
    Refuse(file, "states an unsupported space: \"" + std::string(name) + "\"",
           "write it again with SPACE=LPS or SPACE=RAS");
  }
  return name == "RAS" ? SurfaceSpace::Ras : SurfaceSpace::Lps;
}

void ReverseXAndY(vtkDataArray* vectors)
{
  const bool areVectors = vectors != nullptr && vectors->GetNumberOfComponents() == 3;
  for (vtkIdType i = 0; areVectors && i < vectors->GetNumberOfTuples(); ++i)
  {
    for (const int k : {0, 1})
    {
      vectors->SetComponent(i, k, 0.0 - vectors->GetComponent(i, k));
    }
  }
}

void ReverseXAndY(vtkDataSetAttributes* attributes)
{
  ReverseXAndY(attributes->GetNormals());
  if (attributes->GetVectors() != attributes->GetNormals())
  {
    ReverseXAndY(attributes->GetVectors());
  }
}
} // namespace

SurfaceSpace SpaceOfComments(const std::filesystem::path& file, std::string_view comments)
{
  for (std::size_t at = comments.find(Tag); at != std::string_view::npos;
       at = comments.find(Tag, at + Tag.size()))
  {
    const std::size_t start = at + Tag.size();
    std::size_t end = start;
    while (end < comments.size() && IsWordLetter(comments[end]))
    {
      ++end;
    }
    if (at == 0 || !IsWordLetter(comments[at - 1]))
    {
      return SpaceNamed(file, comments.substr(start, end - start));
    }
  }
  return SurfaceSpace::Lps;
}

SurfaceSpace TakeSpaceOfFields(const std::filesystem::path& file, vtkPolyData* surface)
{
  vtkFieldData* fields = surface->GetFieldData();
  auto* array = vtkStringArray::SafeDownCast(fields->GetAbstractArray("SPACE"));
  if (array == nullptr || array->GetNumberOfValues() < 1)
  {
    return SurfaceSpace::Lps;
  }
  const std::string name = array->GetValue(0);
  fields->RemoveArray("SPACE");
  return SpaceNamed(file, name);
}

void TurnToLps(SurfaceSpace space, vtkPolyData* surface)
{
  if (space == SurfaceSpace::Lps || surface->GetPoints() == nullptr)
  {
    return;
  }
  ReverseXAndY(surface->GetPoints()->GetData());
  ReverseXAndY(surface->GetPointData());
  ReverseXAndY(surface->GetCellData());
  surface->GetPoints()->Modified();
}
} // namespace palpate
