#include "vtkSphericalHarmonicSurface.h"

#include "ClosestPointDistances.h"
#include "DirectionCaster.h"
#include "FitDeviation.h"
#include "IcosahedronDirections.h"
#include "MeshConversion.h"
#include "ModelTable.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

vtkStandardNewMacro(vtkSphericalHarmonicSurface);

namespace
{
using palpate::Vector3;

vtkNew<vtkDoubleArray> MakeArray(const char* name, std::size_t count, int components = 1)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

void AddGeometry(const palpate::SphericalHarmonicModel& model,
                 const palpate::IcosahedronDirections& sphere, vtkPolyData* output)
{
  const std::vector<Vector3>& directions = sphere.Directions();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(directions.size()));
  auto radii = MakeArray("Radius", directions.size());
  auto normals = MakeArray("Normals", directions.size(), 3);
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const double radius = model.Radius(directions[i]);
    points->SetPoint(id, Vector3(model.CenterWorld() + radius * directions[i]).data());
    radii->SetValue(id, radius);
    normals->SetTuple(id, model.Normal(directions[i]).data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const std::array<int, 3>& t : sphere.Triangles())
  {
    triangles->InsertNextCell({t[0], t[1], t[2]});
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->AddArray(radii);
  output->GetPointData()->SetNormals(normals);
}

void AddDeviation(vtkDataArray* factorArray, int degree, const std::vector<Vector3>& directions,
                  vtkPolyData* output)
{
  const vtkIdType size = (degree + 1) * (degree + 1);
  auto* values = vtkDoubleArray::SafeDownCast(factorArray);
  if (values != nullptr && values->GetNumberOfTuples() == size &&
      values->GetNumberOfComponents() == size)
  {
    const palpate::CovarianceFactor factor(values->GetPointer(0), size, size);
    output->GetPointData()->AddArray(palpate::FitDeviation(factor, directions, "RadiusDeviation"));
  }
}

void AddComparison(const palpate::SphericalHarmonicModel& model,
                   const std::vector<Vector3>& directions, vtkPolyData* original,
                   vtkPolyData* output)
{
  const palpate::IndexedMesh mesh = palpate::ToIndexedMesh(original);
  const auto crossings = palpate::DirectionCaster(directions).Cast(mesh, model.CenterWorld());
  std::vector<double> radii(directions.size());
  std::vector<Vector3> points(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    radii[i] = model.Radius(directions[i]);
    points[i] = model.CenterWorld() + radii[i] * directions[i];
  }
  const std::vector<double> distances = palpate::ClosestPointDistances(points, mesh);
  auto signedDistances = MakeArray("DistanceToSurface", directions.size());
  auto residuals = MakeArray("Residual", directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const bool isInside = palpate::IsInside(crossings[i], radii[i]);
    signedDistances->SetValue(id, isInside ? -distances[i] : distances[i]);
    residuals->SetValue(id, crossings[i].empty() ? vtkMath::Nan()
                                                 : crossings[i].back().Distance - radii[i]);
  }
  output->GetPointData()->AddArray(signedDistances);
  output->GetPointData()->AddArray(residuals);
}
} // namespace

void vtkSphericalHarmonicSurface::SetOriginalData(vtkPolyData* surface)
{
  this->SetInputDataObject(1, surface);
}

int vtkSphericalHarmonicSurface::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkTable" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkSphericalHarmonicSurface::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                             vtkInformationVector* outputs)
{
  vtkTable* table = vtkTable::GetData(inputs[0]);
  vtkPolyData* original = vtkPolyData::GetData(inputs[1]);
  palpate::SphericalHarmonicModel model;
  if (!palpate::FromTable(table, model))
  {
    vtkErrorMacro("the input is not a spherical-harmonic model: it needs the columns Degree, Order "
                  "and Coefficient and the field Center");
    return 0;
  }
  const palpate::IcosahedronDirections sphere(this->Frequency);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  AddGeometry(model, sphere, output);
  this->UpdateProgress(0.3);
  if (vtkDataArray* factor = table->GetFieldData()->GetArray("CovarianceFactor"))
  {
    AddDeviation(factor, model.Degree(), sphere.Directions(), output);
  }
  this->UpdateProgress(0.6);
  if (original != nullptr && original->GetNumberOfPolys() > 0 && !this->AbortExecute)
  {
    AddComparison(model, sphere.Directions(), original, output);
  }
  this->UpdateProgress(1.0);
  return 1;
}

void vtkSphericalHarmonicSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frequency: " << this->Frequency << "\n";
}
