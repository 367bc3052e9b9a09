#include "vtkSegmentationSurface.h"

#include "ImageIndexToWorld.h"
#include "LabelMask.h"
#include "MaskSurface.h"
#include "MeshConversion.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkSegmentationSurface);

void vtkSegmentationSurface::SetSmoothing(double smoothing)
{
  // Written so that NaN, for which every comparison is false, becomes 0.
  const double clamped = smoothing > 0.0 ? std::min(smoothing, 10.0) : 0.0;
  if (this->Smoothing != clamped)
  {
    this->Smoothing = clamped;
    this->Modified();
  }
}

int vtkSegmentationSurface::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkSegmentationSurface::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                        vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (scalars == nullptr || scalars->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro("the label map needs scalars of one component");
    return 0;
  }
  palpate::LabelMask copied = palpate::CopyLabelMask(image, this->Label, 1);
  this->TouchesBorder = copied.TouchesBorder();
  if (copied.Mask.Inside.empty())
  {
    vtkErrorMacro("no voxel has label " << this->Label);
    return 0;
  }
  const palpate::MaskSurfaceSettings settings{
      this->Method == PLAIN, {this->Smoothing, this->CellsOnSurface}, this->Component};
  const palpate::KernelProgress progress = [this](double fraction)
  {
    this->UpdateProgress(fraction);
    return this->AbortExecute == 0;
  };
  palpate::MaskSurface made;
  const palpate::Status status = palpate::MakeMaskSurface(
      std::move(copied.Mask), palpate::IndexToWorldOf(image), settings, progress, made);
  this->ComponentVolumes = std::move(made.ComponentVolumes);
  if (this->AbortExecute)
  {
    return 1;
  }
  if (!status.IsOk())
  {
    vtkErrorMacro(<< "label " << this->Label << " " << status.Message());
    return 0;
  }
  this->MaskVolume = made.MaskVolume;
  this->SurfaceVolume = made.SurfaceVolume;
  this->CavityCount = made.FilledCavities.Count;
  this->CavityVolume = made.FilledCavities.Volume;
  this->LargestCavityVolume = made.FilledCavities.LargestVolume;
  output->ShallowCopy(palpate::ToPolyData(made.Mesh));
  this->UpdateProgress(1.0);
  return 1;
}

void vtkSegmentationSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "Method: " << (this->Method == PLAIN ? "plain" : "shape interpolation") << "\n";
  os << indent << "Smoothing: " << this->Smoothing << " voxels\n";
  os << indent << "CellsOnSurface: " << this->CellsOnSurface << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "TouchesBorder: " << this->TouchesBorder << "\n";
  os << indent << "MaskVolume: " << this->MaskVolume << " mm^3\n";
  os << indent << "SurfaceVolume: " << this->SurfaceVolume << " mm^3\n";
  os << indent << "CavityCount: " << this->CavityCount << "\n";
  os << indent << "CavityVolume: " << this->CavityVolume << " mm^3\n";
  os << indent << "LargestCavityVolume: " << this->LargestCavityVolume << " mm^3\n";
  os << indent << "NumberOfComponents: " << this->GetNumberOfComponents() << "\n";
}
