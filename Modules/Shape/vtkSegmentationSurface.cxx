#include "vtkSegmentationSurface.h"

#include "IsoSurface.h"
#include "LabelMask.h"
#include "MaskComponents.h"
#include "SignedDistanceField.h"
#include "VoxelMask.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSegmentationSurface);

namespace
{
// Wide enough for the blur not to reach the border; the outermost samples stay outside.
int RimFor(double smoothing)
{
  return 2 + static_cast<int>(std::ceil(1.5 * smoothing));
}
} // namespace

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
  const bool plain = this->Method == PLAIN;
  palpate::LabelMask copied =
      palpate::CopyLabelMask(image, this->Label, plain ? 1 : RimFor(this->Smoothing));
  this->TouchesBorder = copied.TouchesBorder;
  palpate::VoxelMask& mask = copied.Mask;
  if (mask.Inside.empty())
  {
    vtkErrorMacro("no voxel has label " << this->Label);
    return 0;
  }
  this->UpdateProgress(0.1);
  if (this->AbortExecute || !this->SelectComponent(mask))
  {
    return this->AbortExecute ? 1 : 0;
  }
  this->UpdateProgress(0.3);
  return this->AbortExecute || this->BuildSurface(mask, image, output) ? 1 : 0;
}

bool vtkSegmentationSurface::SelectComponent(palpate::VoxelMask& mask)
{
  const palpate::MaskComponents components(mask);
  const double voxel = mask.VoxelVolume();
  this->ComponentVolumes.clear();
  for (const long long count : components.VoxelCounts())
  {
    this->ComponentVolumes.push_back(static_cast<double>(count) * voxel);
  }
  if (this->Component > this->GetNumberOfComponents())
  {
    const int count = this->GetNumberOfComponents();
    vtkErrorMacro("there is no component " << this->Component << ": label " << this->Label
                                           << " has " << count << " connected component"
                                           << (count == 1 ? "" : "s"));
    return false;
  }
  if (this->Component > 0)
  {
    components.Keep(this->Component - 1, mask);
  }
  this->MaskVolume = static_cast<double>(mask.Count()) * voxel;
  const palpate::MaskCavities cavities = palpate::FillCavities(mask);
  this->CavityCount = cavities.Count;
  this->CavityVolume = static_cast<double>(cavities.Voxels) * voxel;
  return true;
}

bool vtkSegmentationSurface::BuildSurface(const palpate::VoxelMask& mask, vtkImageData* image,
                                          vtkPolyData* output)
{
  const auto pieces =
      this->Component > 0 ? palpate::SurfacePieces::Largest : palpate::SurfacePieces::All;
  const double volume = this->MaskVolume + this->CavityVolume;
  palpate::IsoSurface surface;
  palpate::ScalarGrid grid;
  const auto extract = [&](palpate::FieldMethod method)
  {
    grid = palpate::BuildField(mask, method, this->Smoothing);
    this->UpdateProgress(0.6);
    surface = method == palpate::FieldMethod::Plain
                  ? palpate::ExtractIsoSurface(grid, 0.0f, pieces)
                  : palpate::ExtractIsoSurfaceOfVolume(grid, volume, pieces);
  };
  const palpate::FieldMethod method =
      this->Method == PLAIN ? palpate::FieldMethod::Plain : palpate::SuitableMethod(mask);
  extract(method);
  // A level far from zero means that the interpolation tore a thin, oblique shape apart.
  this->UsedDistanceInstead =
      method == palpate::FieldMethod::ShapeInterpolation && std::abs(surface.Level) > 0.25;
  if (this->UsedDistanceInstead)
  {
    extract(palpate::FieldMethod::Distance);
  }
  if (surface.Surface->GetNumberOfPolys() == 0)
  {
    vtkErrorMacro("label " << this->Label << " is too thin to have a surface");
    return false;
  }
  this->SurfaceVolume = palpate::MeasureEnclosed(surface.Surface).Volume;
  palpate::MoveToWorld(grid, image, surface.Surface);
  output->ShallowCopy(surface.Surface);
  this->UpdateProgress(1.0);
  return true;
}

void vtkSegmentationSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "Method: " << (this->Method == PLAIN ? "plain" : "shape interpolation") << "\n";
  os << indent << "Smoothing: " << this->Smoothing << " voxels\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "TouchesBorder: " << this->TouchesBorder << "\n";
  os << indent << "MaskVolume: " << this->MaskVolume << " mm^3\n";
  os << indent << "SurfaceVolume: " << this->SurfaceVolume << " mm^3\n";
  os << indent << "CavityCount: " << this->CavityCount << "\n";
  os << indent << "CavityVolume: " << this->CavityVolume << " mm^3\n";
  os << indent << "NumberOfComponents: " << this->GetNumberOfComponents() << "\n";
  os << indent << "UsedDistanceInstead: " << this->UsedDistanceInstead << "\n";
}
