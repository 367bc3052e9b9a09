#include "vtkRadialModelFit.h"

#include "DegreeSearch.h"
#include "ModelTable.h"
#include "RadialModelFit.h"
#include "SphericalHarmonicBasis.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <utility>

vtkStandardNewMacro(vtkRadialModelFit);

namespace
{
bool CollectSamples(vtkPolyData* input, int weighting, palpate::RadialSamples& samples)
{
  const char* weightName = weighting == vtkRadialModelFit::AREA ? "AreaWeight" : "SolidAngle";
  vtkDataArray* direction = input->GetPointData()->GetArray("Direction");
  vtkDataArray* radius = input->GetPointData()->GetArray("Radius");
  vtkDataArray* valid = input->GetPointData()->GetArray("Valid");
  vtkDataArray* weight = weighting == vtkRadialModelFit::UNIFORM
                             ? nullptr
                             : input->GetPointData()->GetArray(weightName);
  vtkDataArray* center = input->GetFieldData()->GetArray("Center");
  if (direction == nullptr || direction->GetNumberOfComponents() != 3 || radius == nullptr ||
      center == nullptr || center->GetNumberOfComponents() != 3)
  {
    return false;
  }
  for (vtkIdType id = 0; id < input->GetNumberOfPoints(); ++id)
  {
    if (valid == nullptr || valid->GetTuple1(id) != 0.0)
    {
      samples.Directions.emplace_back(direction->GetTuple3(id));
      samples.Radii.push_back(radius->GetTuple1(id));
      samples.Weights.push_back(weight != nullptr ? weight->GetTuple1(id) : 1.0);
    }
  }
  return true;
}

void AddCovariance(const Eigen::MatrixXd& factor, vtkTable* output)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("CovarianceFactor");
  array->SetNumberOfComponents(static_cast<int>(factor.cols()));
  array->SetNumberOfTuples(factor.rows());
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      array->GetPointer(0), factor.rows(), factor.cols()) = factor;
  output->GetFieldData()->AddArray(array);
}
} // namespace

int vtkRadialModelFit::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkRadialModelFit::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  palpate::RadialSamples samples;
  if (!CollectSamples(input, this->Weighting, samples))
  {
    vtkErrorMacro(
        "the input has no samples: it needs the arrays Direction and Radius and the field "
        "Center, as vtkRadialSampler writes them");
    return 0;
  }
  palpate::RadialModelFitOptions options;
  options.Degree = this->Degree;
  options.PenaltyKind = static_cast<palpate::RadialModelFitOptions::Penalty>(this->Penalty);
  options.Roughness = this->Roughness;
  options.MaximumCondition = this->MaximumCondition;
  options.RobustKind = this->Robust ? palpate::RadialModelFitOptions::Robust::Huber
                                    : palpate::RadialModelFitOptions::Robust::None;
  options.IsCancelled = [this] { return this->AbortExecute != 0; };
  this->UpdateProgress(0.1);
  palpate::RadialModelFitResult result;
  palpate::Status status = this->Tolerance > 0.0
                               ? palpate::FindDegree(samples, options,
                                                     {this->Tolerance, this->LeastDegree,
                                                      this->MaximumDegree, this->SupportedDegree},
                                                     options.Degree)
                               : palpate::Status::Success();
  if (status.IsOk() && !this->AbortExecute)
  {
    status = palpate::FitRadialModel(samples, options, result);
  }
  if (status.IsOk() && !this->AbortExecute)
  {
    this->UpdateProgress(0.7);
    status = palpate::AssessCoverage(samples.Directions, samples.Weights, result, this->Coverage);
  }
  if (this->AbortExecute)
  {
    return 1;
  }
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  this->FittedDegree = options.Degree;
  this->Condition = result.Condition;
  this->UsedRoughness = result.Roughness;
  this->Rms = result.Rms;
  this->NoiseDeviation = result.NoiseDeviation;
  this->DegreesOfFreedom = result.DegreesOfFreedom;
  this->DownWeighted = static_cast<int>(result.DownWeighted);
  this->RmsByDegree = result.RmsByDegree;
  const palpate::Vector3 center(input->GetFieldData()->GetArray("Center")->GetTuple3(0));
  vtkTable* output = vtkTable::GetData(outputs);
  palpate::ToTable(palpate::RadialModel(options.Degree, std::move(result.Coefficients), center),
                   output);
  AddCovariance(result.Covariance.Factor(), output);
  this->UpdateProgress(1.0);
  return 1;
}

void vtkRadialModelFit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Degree: " << this->Degree << "\n";
  os << indent << "Weighting: " << this->Weighting << "\n";
  os << indent << "Tolerance: " << this->Tolerance << " mm\n";
  os << indent << "MaximumDegree: " << this->MaximumDegree << "\n";
  os << indent << "LeastDegree: " << this->LeastDegree << "\n";
  os << indent << "SupportedDegree: " << this->SupportedDegree << "\n";
  os << indent << "Penalty: " << this->Penalty << "\n";
  os << indent << "Roughness: " << this->Roughness << "\n";
  os << indent << "MaximumCondition: " << this->MaximumCondition << "\n";
  os << indent << "Robust: " << this->Robust << "\n";
  os << indent << "FittedDegree: " << this->FittedDegree << "\n";
  os << indent << "Condition: " << this->Condition << "\n";
  os << indent << "UsedRoughness: " << this->UsedRoughness << "\n";
  os << indent << "Rms: " << this->Rms << " mm\n";
  os << indent << "NoiseDeviation: " << this->NoiseDeviation << " mm\n";
  os << indent << "DegreesOfFreedom: " << this->DegreesOfFreedom << "\n";
  os << indent << "DownWeighted: " << this->DownWeighted << "\n";
  os << indent << "Coverage: " << this->Coverage.Message << "\n";
}
