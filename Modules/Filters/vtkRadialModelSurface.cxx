#include "vtkRadialModelSurface.h"

#include "MeshConversion.h"
#include "ModelTable.h"
#include "RadialModelSurface.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <Eigen/Core>
#include <optional>

vtkStandardNewMacro(vtkRadialModelSurface);

namespace
{
// The factor of the covariance of a model's coefficients, stored row by row.
std::optional<Eigen::MatrixXd> FactorOf(vtkDataArray* array, const palpate::RadialModel& model)
{
  const auto size = static_cast<Eigen::Index>(model.Coefficients().size());
  auto* values = vtkDoubleArray::SafeDownCast(array);
  if (values == nullptr || values->GetNumberOfTuples() != size ||
      values->GetNumberOfComponents() != size)
  {
    return std::nullopt;
  }
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(values->GetPointer(0), size, size);
}
} // namespace

void vtkRadialModelSurface::SetOriginalData(vtkPolyData* surface)
{
  this->SetInputDataObject(1, surface);
}

int vtkRadialModelSurface::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkTable" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkRadialModelSurface::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                       vtkInformationVector* outputs)
{
  vtkTable* table = vtkTable::GetData(inputs[0]);
  vtkPolyData* original = vtkPolyData::GetData(inputs[1]);
  palpate::RadialModel model;
  if (!palpate::FromTable(table, model))
  {
    vtkErrorMacro("the input is not a spherical-harmonic model: it needs the columns Degree, Order "
                  "and Coefficient and the field Center");
    return 0;
  }
  const std::optional<Eigen::MatrixXd> factor =
      FactorOf(table->GetFieldData()->GetArray("CovarianceFactor"), model);
  const palpate::IndexedMesh mesh =
      original != nullptr ? palpate::ToIndexedMesh(original) : palpate::IndexedMesh();
  vtkPolyData::GetData(outputs)->ShallowCopy(
      palpate::DrawRadialModel(model, this->Frequency, {factor ? &*factor : nullptr, &mesh}));
  this->UpdateProgress(1.0);
  return 1;
}

void vtkRadialModelSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frequency: " << this->Frequency << "\n";
}
