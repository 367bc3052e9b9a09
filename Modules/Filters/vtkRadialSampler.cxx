#include "vtkRadialSampler.h"

#include "MeshConversion.h"
#include "RadialSampling.h"
#include "StarShape.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRadialSampler);

namespace
{
using palpate::Vector3;

std::vector<Vector3> UnitDirections(vtkPolyData* directions)
{
  std::vector<Vector3> result(static_cast<std::size_t>(directions->GetNumberOfPoints()));
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    directions->GetPoint(static_cast<vtkIdType>(i), result[i].data());
    // Those of unit length keep their bits, as palpate::SampleRadially has them.
    if (std::abs(result[i].squaredNorm() - 1.0) > 1e-12)
    {
      result[i].normalize();
    }
  }
  return result;
}

Vector3 ChooseCenter(const palpate::IndexedMesh& mesh, int mode, const double* given)
{
  switch (mode)
  {
  case vtkRadialSampler::GIVEN:
    return Vector3(given);
  case vtkRadialSampler::MOST_VISIBLE:
    return palpate::MostVisibleCenter(mesh);
  default:
    return palpate::VolumeCentroid(mesh);
  }
}

std::vector<double> SolidAngles(vtkPolyData* directions)
{
  const auto count = static_cast<std::size_t>(directions->GetNumberOfPoints());
  std::vector<double> angles(count, 4.0 * M_PI / static_cast<double>(count));
  if (vtkDataArray* given = directions->GetPointData()->GetArray("SolidAngle"))
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      angles[i] = given->GetTuple1(static_cast<vtkIdType>(i));
    }
  }
  return angles;
}

template <typename Array, typename Value>
void AddArray(const char* name, const std::vector<Value>& values, vtkPolyData* output)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  output->GetPointData()->AddArray(array);
}

void AddSamples(const palpate::RadialSampling& sampling, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(sampling.Directions.size());
  vtkNew<vtkDoubleArray> direction;
  direction->SetName("Direction");
  direction->SetNumberOfComponents(3);
  direction->SetNumberOfTuples(count);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  std::vector<unsigned char> valid(sampling.Directions.size());
  for (vtkIdType id = 0; id < count; ++id)
  {
    const auto i = static_cast<std::size_t>(id);
    const Vector3& u = sampling.Directions[i];
    direction->SetTuple(id, u.data());
    points->SetPoint(id, Vector3(sampling.CenterWorld + sampling.Radii[i] * u).data());
    valid[i] = sampling.Crossings[i] > 0 ? 1 : 0;
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(direction);
  AddArray<vtkDoubleArray>("Radius", sampling.Radii, output);
  AddArray<vtkIntArray>("Crossings", sampling.Crossings, output);
  AddArray<vtkUnsignedCharArray>("Valid", valid, output);
  AddArray<vtkDoubleArray>("SolidAngle", sampling.SolidAngles, output);
  AddArray<vtkDoubleArray>("AreaWeight", sampling.AreaWeights, output);
}
} // namespace

int vtkRadialSampler::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                  vtkInformationVector* outputs)
{
  const palpate::IndexedMesh mesh = palpate::ToIndexedMesh(vtkPolyData::GetData(inputs[0]));
  vtkPolyData* directionInput = vtkPolyData::GetData(inputs[1]);
  if (mesh.Triangles.empty() || directionInput->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro("the sampler needs a surface and directions; one of them is empty");
    return 0;
  }
  const Vector3 center = ChooseCenter(mesh, this->CenterMode, this->Center);
  std::copy_n(center.data(), 3, this->Center);
  this->UpdateProgress(0.3);
  if (this->AbortExecute)
  {
    return 1;
  }
  const palpate::KernelProgress progress = [this](double fraction)
  {
    this->UpdateProgress(0.3 + 0.7 * fraction);
    return this->AbortExecute == 0;
  };
  const auto crossing =
      this->UseOutermost ? palpate::RadialCrossing::Outermost : palpate::RadialCrossing::Innermost;
  const palpate::RadialSampling sampling =
      palpate::SampleRadially(mesh, center, UnitDirections(directionInput),
                              SolidAngles(directionInput), crossing, progress);
  if (this->AbortExecute)
  {
    return 1;
  }
  this->StarShaped = sampling.Seen.IsStarShaped;
  this->HiddenPercent = sampling.Seen.HiddenPercent;
  this->MultiplePercent = sampling.MultiplePercent;
  this->MissedPercent = sampling.MissedPercent;

  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->CopyStructure(directionInput);
  AddSamples(sampling, output);
  vtkNew<vtkDoubleArray> centerArray;
  centerArray->SetName("Center");
  centerArray->SetNumberOfComponents(3);
  centerArray->InsertNextTuple(this->Center);
  output->GetFieldData()->AddArray(centerArray);
  this->UpdateProgress(1.0);
  return 1;
}

void vtkRadialSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CenterMode: " << this->CenterMode << "\n";
  os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " " << this->Center[2]
     << " mm\n";
  os << indent << "UseOutermost: " << this->UseOutermost << "\n";
  os << indent << "StarShaped: " << this->StarShaped << "\n";
  os << indent << "HiddenPercent: " << this->HiddenPercent << "\n";
  os << indent << "MultiplePercent: " << this->MultiplePercent << "\n";
  os << indent << "MissedPercent: " << this->MissedPercent << "\n";
}
