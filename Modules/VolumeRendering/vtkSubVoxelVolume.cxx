#include "vtkSubVoxelVolume.h"

#include "vtkSubVoxelVolumeMapper.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSubVoxelVolume);

bool vtkSubVoxelVolume::IsOpaque()
{
  auto* mapper = vtkSubVoxelVolumeMapper::SafeDownCast(this->GetMapper());
  return mapper != nullptr && mapper->IsOpaque();
}

int vtkSubVoxelVolume::RenderOpaqueGeometry(vtkViewport* viewport)
{
  return this->IsOpaque() ? this->Superclass::RenderVolumetricGeometry(viewport)
                          : this->Superclass::RenderOpaqueGeometry(viewport);
}

int vtkSubVoxelVolume::RenderVolumetricGeometry(vtkViewport* viewport)
{
  return this->IsOpaque() ? 0 : this->Superclass::RenderVolumetricGeometry(viewport);
}

void vtkSubVoxelVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Opaque: " << this->IsOpaque() << '\n';
}
