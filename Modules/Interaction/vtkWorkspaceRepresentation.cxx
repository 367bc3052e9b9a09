#include "vtkWorkspaceRepresentation.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(vtkWorkspaceRepresentation);

namespace
{
// Two triangles per side, facing outwards.
constexpr std::array<std::array<vtkIdType, 3>, 12> Triangles{{{0, 2, 3},
                                                              {0, 3, 1},
                                                              {4, 5, 7},
                                                              {4, 7, 6},
                                                              {0, 1, 5},
                                                              {0, 5, 4},
                                                              {2, 6, 7},
                                                              {2, 7, 3},
                                                              {0, 4, 6},
                                                              {0, 6, 2},
                                                              {1, 3, 7},
                                                              {1, 7, 5}}};
} // namespace

vtkWorkspaceRepresentation::vtkWorkspaceRepresentation() : Box(vtkSmartPointer<vtkPolyData>::New())
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int corner = 0; corner < 8; ++corner)
  {
    points->InsertNextPoint(0.0, 0.0, 0.0);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : Triangles)
  {
    triangles->InsertNextCell(3, triangle.data());
  }
  this->Box->SetPoints(points);
  this->Box->SetPolys(triangles);
}

vtkWorkspaceRepresentation::~vtkWorkspaceRepresentation() = default;

void vtkWorkspaceRepresentation::SetCorners(const double corners[24])
{
  if (!std::all_of(corners, corners + 24, [](double value) { return std::isfinite(value); }))
  {
    return;
  }
  bool isOther = false;
  for (int c = 0; c < 8; ++c)
  {
    double before[3];
    this->GetCorner(c, before);
    isOther = isOther || !std::equal(before, before + 3, corners + 3 * c);
  }
  if (isOther)
  {
    for (int c = 0; c < 8; ++c)
    {
      this->Box->GetPoints()->SetPoint(c, corners + 3 * c);
    }
    this->Box->GetPoints()->Modified();
    this->Modified();
  }
}

void vtkWorkspaceRepresentation::GetCorner(int number, double world[3])
{
  this->Box->GetPoints()->GetPoint(std::clamp(number, 0, 7), world);
}

vtkPolyData* vtkWorkspaceRepresentation::GetBox()
{
  return this->Box;
}

void vtkWorkspaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Box: " << this->Box.Get() << '\n';
  os << indent << "Color: (" << this->Color[0] << ", " << this->Color[1] << ", " << this->Color[2]
     << ")\n";
  os << indent << "Visibility: " << this->Visibility << '\n';
}
