#include "vtkElasticSurface.h"

#include "DentedSurface.h"
#include "ElasticForce.h"
#include "FeltStiffness.h"
#include "IcosahedronDirections.h"
#include "ModelTable.h"
#include "OrganSoftening.h"
#include "Units.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>

vtkStandardNewMacro(vtkElasticSurface);

namespace
{
using palpate::Vector3;

constexpr double Radian = palpate::Pi / 180.0;

std::shared_ptr<const palpate::TissueMap::Samples> ModuliOf(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  std::array<double, 3> first{};
  image->TransformIndexToPhysicalPoint(image->GetExtent()[0], image->GetExtent()[2],
                                       image->GetExtent()[4], first.data());
  palpate::Matrix3 direction;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      direction(row, column) = image->GetDirectionMatrix()->GetElement(row, column);
    }
  }
  auto samples = std::make_shared<palpate::TissueMap::Samples>();
  samples->Grid = palpate::FieldGrid({size[0], size[1], size[2]}, Vector3(first.data()),
                                     Vector3(image->GetSpacing()), direction);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; values != nullptr && i < values->GetNumberOfTuples(); ++i)
  {
    samples->Values.push_back(
        static_cast<float>(palpate::MegapascalsPerKilopascal * values->GetComponent(i, 0)));
  }
  return samples;
}

void AddArray(vtkPolyData* output, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  output->GetPointData()->AddArray(array);
}
} // namespace

// What the elasticity was made from, and the result.
struct vtkElasticSurface::Softened
{
  vtkMTimeType TableTime = 0;
  vtkMTimeType ImageTime = 0;
  std::array<double, 8> Tissue{};
  palpate::RadialModel Model;
  palpate::ComplianceMaps Maps;
};

vtkElasticSurface::vtkElasticSurface()
{
  this->SetNumberOfInputPorts(2);
}

vtkElasticSurface::~vtkElasticSurface() = default;

void vtkElasticSurface::SetModulusData(vtkImageData* image)
{
  this->SetInputDataObject(1, image);
}

int vtkElasticSurface::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkTable" : "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

bool vtkElasticSurface::Soften(vtkTable* table, vtkImageData* moduli)
{
  const std::array<double, 8> tissue{{this->TissueModulus, this->PoissonRatio,
                                      this->SupportStiffness, this->FreeDirection[0],
                                      this->FreeDirection[1], this->FreeDirection[2],
                                      this->FreeAngle, static_cast<double>(this->ElementsAcross)}};
  const vtkMTimeType imageTime = moduli != nullptr ? moduli->GetMTime() : 0;
  if (this->Made != nullptr && this->Made->TableTime == table->GetMTime() &&
      this->Made->ImageTime == imageTime && this->Made->Tissue == tissue)
  {
    return true;
  }
  this->Made.reset();
  auto made = std::make_unique<Softened>();
  made->TableTime = table->GetMTime();
  made->ImageTime = imageTime;
  made->Tissue = tissue;
  if (!palpate::FromTable(table, made->Model))
  {
    vtkErrorMacro("the input is not a spherical-harmonic model: it needs the columns Degree, Order "
                  "and Coefficient and the field Center");
    return false;
  }
  palpate::ElasticSolid solid{
      palpate::TissueMap(palpate::MegapascalsPerKilopascal * this->TissueModulus),
      this->PoissonRatio,
      palpate::ElasticBed(palpate::MegapascalsPerKilopascal * this->SupportStiffness)};
  if (this->FreeAngle > 0.0)
  {
    solid.Bed.Free(Vector3(this->FreeDirection), Radian * this->FreeAngle);
  }
  if (moduli != nullptr)
  {
    solid.Tissue.AddImage(ModuliOf(moduli));
  }
  palpate::OrganSoftening numbers;
  numbers.ElementsAcross = this->ElementsAcross + this->ElementsAcross % 2;
  palpate::OrganSoftening::Account account;
  const palpate::Status status = numbers.Make(
      made->Model, solid,
      [this](double fraction)
      {
        this->UpdateProgress(0.95 * fraction);
        return this->AbortExecute == 0;
      },
      made->Maps, account);
  if (!status.IsOk())
  {
    if (this->AbortExecute == 0)
    {
      vtkErrorMacro(<< status.Message());
    }
    return false;
  }
  this->Made = std::move(made);
  return true;
}

void vtkElasticSurface::Draw(vtkPolyData* output) const
{
  const palpate::IcosahedronDirections sphere(this->Frequency);
  const palpate::DentedSurface dented(this->Made->Model, this->Made->Maps, sphere.Directions());
  const Vector3 direction = Vector3(this->BallDirection).normalized();
  const bool isPressed = this->BallDepth > 0.0 && direction.allFinite();
  const auto points =
      isPressed ? dented.PointsWorld(dented.PressedAt(direction, this->BallDepth, this->BallRadius))
                : dented.RestWorld();
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const Vector3& point : points)
  {
    places->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const std::array<int, 3>& t : sphere.Triangles())
  {
    triangles->InsertNextCell({t[0], t[1], t[2]});
  }
  output->SetPoints(places);
  output->SetPolys(triangles);
  const auto felt = palpate::FeltStiffness::Of(this->Made->Model, this->Made->Maps,
                                               this->BallRadius, sphere.Directions());
  AddArray(output, "Force", felt.Forces);
  AddArray(output, "NoticedStiffness", felt.Noticed);
  palpate::ElasticForce force;
  if (isPressed)
  {
    force = palpate::ElasticForce::Of(palpate::ComplianceAtlas(this->Made->Maps), this->Made->Model,
                                      direction, this->BallDepth, this->BallRadius);
  }
  vtkNew<vtkDoubleArray> ballForce;
  ballForce->SetName("BallForce");
  ballForce->SetNumberOfComponents(3);
  ballForce->InsertNextTuple(force.ForceWorld.data());
  output->GetFieldData()->AddArray(ballForce);
}

int vtkElasticSurface::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs)
{
  if (!this->Soften(vtkTable::GetData(inputs[0]), vtkImageData::GetData(inputs[1])))
  {
    return this->AbortExecute != 0 ? 1 : 0;
  }
  this->Draw(vtkPolyData::GetData(outputs));
  this->UpdateProgress(1.0);
  return 1;
}

void vtkElasticSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TissueModulus: " << this->TissueModulus << "\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "SupportStiffness: " << this->SupportStiffness << "\n";
  os << indent << "FreeAngle: " << this->FreeAngle << "\n";
  os << indent << "ElementsAcross: " << this->ElementsAcross << "\n";
  os << indent << "BallRadius: " << this->BallRadius << "\n";
  os << indent << "BallDepth: " << this->BallDepth << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
}
