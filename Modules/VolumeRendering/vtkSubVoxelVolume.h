/**
 * @class vtkSubVoxelVolume
 * @brief a volume whose opaque surfaces are drawn with the opaque actors
 *
 * VTK draws volumes after translucent polygons, and so over those that lie in front of them. This
 * one, if its mapper is a vtkSubVoxelVolumeMapper without translucent materials, is drawn with the
 * opaque actors, so that translucent polygons in front are blended over it. Otherwise it behaves
 * like a vtkVolume.
 */
#ifndef vtkSubVoxelVolume_h
#define vtkSubVoxelVolume_h

#include "PalpateVolumeRenderingModule.h" // For export macro
#include "vtkVolume.h"

class PALPATEVOLUMERENDERING_EXPORT vtkSubVoxelVolume : public vtkVolume
{
public:
  static vtkSubVoxelVolume* New();
  vtkTypeMacro(vtkSubVoxelVolume, vtkVolume);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderVolumetricGeometry(vtkViewport* viewport) override;

protected:
  vtkSubVoxelVolume() = default;
  ~vtkSubVoxelVolume() override = default;

private:
  vtkSubVoxelVolume(const vtkSubVoxelVolume&) = delete;
  void operator=(const vtkSubVoxelVolume&) = delete;

  bool IsOpaque();
};

#endif
