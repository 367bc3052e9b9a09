#include "vtkSegmentationSurface.h"

#include "IsoSurface.h"
#include "LabelMask.h"
#include "MaskComponents.h"
#include "MaskShape.h"
#include "ShapeField.h"
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
#include <utility>

vtkStandardNewMacro(vtkSegmentationSurface);

namespace
{
palpate::ScalarGrid HalfLevel(const palpate::VoxelMask& mask)
{
  palpate::ScalarGrid grid;
  std::copy(mask.StartIndex.begin(), mask.StartIndex.end(), grid.StartIndex.begin());
  grid.StepIndex = {1.0, 1.0, 1.0};
  grid.Spacing = mask.Spacing;
  grid.Size = mask.Size;
  grid.Values.resize(mask.Inside.size());
  std::transform(mask.Inside.begin(), mask.Inside.end(), grid.Values.begin(),
                 [](unsigned char inside) { return inside != 0 ? 0.5f : -0.5f; });
  return grid;
}

palpate::ScalarGrid ToScalarGrid(palpate::ShapeField&& field, const palpate::VoxelMask& mask)
{
  palpate::ScalarGrid grid;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double origin = field.Grid.Origin[static_cast<Eigen::Index>(axis)];
    grid.Spacing[axis] = field.Grid.Spacing;
    grid.StepIndex[axis] = field.Grid.Spacing / mask.Spacing[axis];
    grid.StartIndex[axis] = mask.StartIndex[axis] + origin / mask.Spacing[axis];
  }
  grid.Size = field.Grid.Size;
  grid.Values = std::move(field.Values);
  return grid;
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
  palpate::LabelMask copied = palpate::CopyLabelMask(image, this->Label, 1);
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
  this->LargestCavityVolume = static_cast<double>(cavities.LargestVoxels) * voxel;
  return true;
}

bool vtkSegmentationSurface::BuildSurface(const palpate::VoxelMask& mask, vtkImageData* image,
                                          vtkPolyData* output)
{
  const auto pieces =
      this->Component > 0 ? palpate::SurfacePieces::Largest : palpate::SurfacePieces::All;
  palpate::ScalarGrid grid;
  palpate::IsoSurface surface;
  if (this->Method == PLAIN)
  {
    grid = HalfLevel(mask);
    surface = palpate::ExtractIsoSurface(grid, 0.0f, pieces);
  }
  else if (!this->BuildShape(mask, pieces, grid, surface))
  {
    return false;
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

bool vtkSegmentationSurface::BuildShape(const palpate::VoxelMask& mask,
                                        palpate::SurfacePieces pieces, palpate::ScalarGrid& grid,
                                        palpate::IsoSurface& surface)
{
  palpate::ShapeField field;
  const double volume = this->MaskVolume + this->CavityVolume;
  if (const palpate::Status status =
          palpate::MakeMaskShape(mask, volume, {this->Smoothing, this->CellsOnSurface}, field);
      !status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return false;
  }
  this->UpdateProgress(0.6);
  grid = ToScalarGrid(std::move(field), mask);
  surface = palpate::ExtractIsoSurfaceOfVolume(grid, volume, pieces);
  return true;
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
