#include "vtkIcosahedronDirections.h"

#include "IcosahedronDirections.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkIcosahedronDirections);

int vtkIcosahedronDirections::RequestData(vtkInformation*, vtkInformationVector**,
                                          vtkInformationVector* outputs)
{
  const palpate::IcosahedronDirections directions(this->Frequency);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const palpate::Vector3& direction : directions.Directions())
  {
    points->InsertNextPoint(direction.data());
  }
  vtkNew<vtkDoubleArray> solidAngles;
  solidAngles->SetName("SolidAngle");
  for (const double angle : directions.SolidAngles())
  {
    solidAngles->InsertNextValue(angle);
  }
  vtkNew<vtkCellArray> triangles;
  for (const std::array<int, 3>& t : directions.Triangles())
  {
    triangles->InsertNextCell({t[0], t[1], t[2]});
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->AddArray(solidAngles);
  return 1;
}

void vtkIcosahedronDirections::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frequency: " << this->Frequency << "\n";
}
