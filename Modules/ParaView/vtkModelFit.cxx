#include "vtkModelFit.h"

#include "FitStructure.h"
#include "Progress.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <utility>

vtkStandardNewMacro(vtkModelFit);

namespace
{
using palpate::FitSettings;

FitSettings::ModelKind KindOf(int model)
{
  switch (model)
  {
  case vtkModelFit::RADIAL:
    return FitSettings::ModelKind::Radial;
  case vtkModelFit::SURFACE:
    return FitSettings::ModelKind::Surface;
  default:
    return FitSettings::ModelKind::Automatic;
  }
}

// The drawn model, with what was measured of it.
void WriteResult(const palpate::FitResult& result, vtkPolyData* output)
{
  output->ShallowCopy(result.ModelSurface);
  const std::pair<const char*, double> facts[] = {{"Dice", result.Dice},
                                                  {"MeanDistance", result.ModelToMask.Mean},
                                                  {"MaximumDistance", result.ModelToMask.Maximum},
                                                  {"Volume", result.ModelMilliliters},
                                                  {"Degree", palpate::DegreeOf(result.Model)}};
  for (const auto& [name, value] : facts)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    output->GetFieldData()->AddArray(array);
  }
}
} // namespace

int vtkModelFit::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkModelFit::RequestData(vtkInformation*, vtkInformationVector** inputs,
                             vtkInformationVector* outputs)
{
  palpate::Segmentation segmentation;
  segmentation.Layers.emplace_back(vtkImageData::GetData(inputs[0]));
  palpate::Segment structure;
  structure.Label = this->Label;
  structure.Value = this->Label;
  FitSettings settings;
  settings.Model = KindOf(this->Model);
  settings.Degree = this->Degree;
  settings.Smoothing = this->Smoothing;
  settings.Repairs = this->Repairs;
  const auto progress = [this](double fraction, const std::string& stage)
  {
    this->SetProgressText(stage.c_str());
    this->UpdateProgress(fraction);
    return this->GetAbortExecute() == 0;
  };
  try
  {
    const palpate::FitResult result =
        palpate::FitStructure(segmentation, structure, settings, progress);
    if (result.State != palpate::FitResult::Outcome::Fitted)
    {
      vtkErrorMacro("Label " << this->Label << ": " << result.Message);
      return 0;
    }
    WriteResult(result, vtkPolyData::GetData(outputs));
    return 1;
  }
  catch (const palpate::Cancelled&)
  {
    return 0;
  }
}

void vtkModelFit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << this->Label << '\n';
  os << indent << "Model: " << this->Model << '\n';
  os << indent << "Degree: " << this->Degree << '\n';
  os << indent << "Smoothing: " << this->Smoothing << '\n';
  os << indent << "Repairs: " << this->Repairs << '\n';
}
