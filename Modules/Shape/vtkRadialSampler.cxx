#include "vtkRadialSampler.h"

#include "DirectionCaster.h"
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
    result[i].normalize();
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

// The output arrays of the samples, one entry per direction.
struct SampleArrays
{
  explicit SampleArrays(vtkIdType count)
  {
    this->Direction->SetName("Direction");
    this->Direction->SetNumberOfComponents(3);
    this->Direction->SetNumberOfTuples(count);
    this->Radius->SetName("Radius");
    this->Radius->SetNumberOfValues(count);
    this->Crossings->SetName("Crossings");
    this->Crossings->SetNumberOfValues(count);
    this->Valid->SetName("Valid");
    this->Valid->SetNumberOfValues(count);
    this->SolidAngle->SetName("SolidAngle");
    this->SolidAngle->SetNumberOfValues(count);
    this->AreaWeight->SetName("AreaWeight");
    this->AreaWeight->SetNumberOfValues(count);
    this->Points->SetDataTypeToDouble();
    this->Points->SetNumberOfPoints(count);
  }

  void AddTo(vtkPolyData* output)
  {
    output->SetPoints(this->Points);
    output->GetPointData()->AddArray(this->Direction);
    output->GetPointData()->AddArray(this->Radius);
    output->GetPointData()->AddArray(this->Crossings);
    output->GetPointData()->AddArray(this->Valid);
    output->GetPointData()->AddArray(this->SolidAngle);
    output->GetPointData()->AddArray(this->AreaWeight);
  }

  vtkNew<vtkDoubleArray> Direction;
  vtkNew<vtkDoubleArray> Radius;
  vtkNew<vtkIntArray> Crossings;
  vtkNew<vtkUnsignedCharArray> Valid;
  vtkNew<vtkDoubleArray> SolidAngle;
  vtkNew<vtkDoubleArray> AreaWeight;
  vtkNew<vtkPoints> Points;
};
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
  const palpate::StarShapeVerdict verdict = palpate::JudgeStarShape(mesh, center);
  this->StarShaped = verdict.IsStarShaped;
  this->HiddenPercent = verdict.HiddenPercent;
  this->UpdateProgress(0.7);

  const std::vector<Vector3> directions = UnitDirections(directionInput);
  const auto crossings = palpate::DirectionCaster(directions).Cast(mesh, center);
  vtkDataArray* solidAngles = directionInput->GetPointData()->GetArray("SolidAngle");
  SampleArrays samples(directionInput->GetNumberOfPoints());
  double total = 0.0;
  double multiple = 0.0;
  double missed = 0.0;
  for (vtkIdType id = 0; id < directionInput->GetNumberOfPoints(); ++id)
  {
    const auto i = static_cast<std::size_t>(id);
    const double angle = solidAngles != nullptr
                             ? solidAngles->GetTuple1(id)
                             : 4.0 * M_PI / static_cast<double>(directions.size());
    const auto& list = crossings[i];
    const palpate::RayCrossing crossing = list.empty()
                                              ? palpate::RayCrossing{-1, 0.0}
                                              : (this->UseOutermost ? list.back() : list.front());
    const double radius = crossing.Distance;
    total += angle;
    multiple += list.size() > 1 ? angle : 0.0;
    missed += list.empty() ? angle : 0.0;
    samples.Direction->SetTuple(id, directions[i].data());
    samples.Radius->SetValue(id, radius);
    samples.Crossings->SetValue(id, static_cast<int>(list.size()));
    samples.Valid->SetValue(id, list.empty() ? 0 : 1);
    samples.SolidAngle->SetValue(id, angle);
    samples.AreaWeight->SetValue(
        id, list.empty() ? 0.0 : palpate::AreaWeightOf(mesh, crossing, directions[i], angle));
    samples.Points->SetPoint(id, Vector3(center + radius * directions[i]).data());
  }
  this->MultiplePercent = 100.0 * multiple / total;
  this->MissedPercent = 100.0 * missed / total;

  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->CopyStructure(directionInput);
  samples.AddTo(output);
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
