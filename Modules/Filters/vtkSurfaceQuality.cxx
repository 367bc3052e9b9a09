#include "vtkSurfaceQuality.h"

#include "MaskOverlap.h"
#include "MeshConversion.h"
#include "MeshDistances.h"
#include "SurfaceTopology.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkSurfaceQuality);

void vtkSurfaceQuality::SetReferenceData(vtkPolyData* surface)
{
  this->SetInputDataObject(1, surface);
}

void vtkSurfaceQuality::SetMaskData(vtkImageData* mask)
{
  this->SetInputDataObject(2, mask);
}

int vtkSurfaceQuality::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 2 ? "vtkImageData" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 2 ? 1 : 0);
  return 1;
}

int vtkSurfaceQuality::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs)
{
  vtkPolyData* tested = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* reference = vtkPolyData::GetData(inputs[1]);
  vtkImageData* mask = vtkImageData::GetData(inputs[2]);
  if (tested->GetNumberOfPolys() == 0 || reference->GetNumberOfPolys() == 0)
  {
    vtkErrorMacro("both surfaces need triangles to be compared");
    return 0;
  }
  const palpate::IndexedMesh testedMesh = palpate::ToIndexedMesh(tested);
  const palpate::IndexedMesh referenceMesh = palpate::ToIndexedMesh(reference);
  palpate::ComparedSurface one;
  palpate::ComparedSurface other;
  palpate::Status status = palpate::ComparedSurface::Make(testedMesh, one);
  if (status.IsOk())
  {
    status = palpate::ComparedSurface::Make(referenceMesh, other);
  }
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  const palpate::DistanceSamples there = one.SamplesFrom(other);
  this->UpdateProgress(0.3);
  const palpate::DistanceSamples back = other.SamplesFrom(one);
  this->UpdateProgress(0.8);
  if (this->AbortExecute)
  {
    return 1;
  }
  const palpate::DistanceSummary distance = palpate::TwoSidedDistances(there, back);
  this->MeanDistance = distance.Mean;
  this->RmsDistance = distance.Rms;
  this->Percentile95Distance = distance.Percentile95;
  this->MaximumDistance = distance.Largest;

  const palpate::EnclosedMeasure measured = palpate::MeasureEnclosed(testedMesh);
  const palpate::EnclosedMeasure expected = palpate::MeasureEnclosed(referenceMesh);
  this->Volume = measured.Volume;
  this->Area = measured.Area;
  this->VolumeDifference = measured.Volume - expected.Volume;
  this->AreaDifference = measured.Area - expected.Area;
  this->Dice = mask != nullptr
                   ? palpate::OverlapOfSurfaceAndMask(testedMesh, mask, this->Label).Dice()
                   : -1.0;

  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(tested);
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("Distance");
  distances->SetNumberOfValues(tested->GetNumberOfPoints());
  std::copy_n(there.Values.begin(), tested->GetNumberOfPoints(), distances->GetPointer(0));
  output->GetPointData()->AddArray(distances);
  this->UpdateProgress(1.0);
  return 1;
}

void vtkSurfaceQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "MeanDistance: " << this->MeanDistance << " mm\n";
  os << indent << "RmsDistance: " << this->RmsDistance << " mm\n";
  os << indent << "Percentile95Distance: " << this->Percentile95Distance << " mm\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << " mm\n";
  os << indent << "Volume: " << this->Volume << " mm^3\n";
  os << indent << "VolumeDifference: " << this->VolumeDifference << " mm^3\n";
  os << indent << "Area: " << this->Area << " mm^2\n";
  os << indent << "AreaDifference: " << this->AreaDifference << " mm^2\n";
  os << indent << "Dice: " << this->Dice << "\n";
}
