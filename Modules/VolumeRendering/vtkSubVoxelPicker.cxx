#include "vtkSubVoxelPicker.h"

#include "vtkSubVoxelVolumeMapper.h"

#include "vtkAssemblyPath.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <algorithm>

vtkStandardNewMacro(vtkSubVoxelPicker);

int vtkSubVoxelPicker::Pick(double x, double y, double z, vtkRenderer* renderer)
{
  this->Initialize();
  this->Renderer = renderer;
  this->SelectionPoint[0] = x;
  this->SelectionPoint[1] = y;
  this->SelectionPoint[2] = z;
  this->Material = -1;
  this->InvokeEvent(vtkCommand::StartPickEvent, nullptr);
  double nearest = 1.0;
  vtkCollectionSimpleIterator place;
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  volumes->InitTraversal(place);
  while (vtkVolume* volume = volumes->GetNextVolume(place))
  {
    auto* mapper = vtkSubVoxelVolumeMapper::SafeDownCast(volume->GetMapper());
    vtkSubVoxelVolumeMapper::SurfacePoint point;
    if (mapper == nullptr || volume->GetVisibility() == 0 || volume->GetPickable() == 0 ||
        !mapper->PickSurface(renderer, volume, x, y, point) || point.Depth > nearest)
    {
      continue;
    }
    nearest = point.Depth;
    this->Material = point.Material;
    std::copy_n(point.Position, 3, this->PickPosition);
    std::copy_n(point.Normal, 3, this->Normal);
    vtkNew<vtkAssemblyPath> path;
    path->AddNode(volume, volume->GetMatrix());
    this->SetPath(path);
  }
  this->InvokeEvent(vtkCommand::EndPickEvent, nullptr);
  return this->Material >= 0 ? 1 : 0;
}

void vtkSubVoxelPicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Material: " << this->Material << '\n';
  os << indent << "Normal: (" << this->Normal[0] << ", " << this->Normal[1] << ", "
     << this->Normal[2] << ")\n";
}
