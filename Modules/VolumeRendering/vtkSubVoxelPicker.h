/**
 * @class vtkSubVoxelPicker
 * @brief picks the surface that a vtkSubVoxelVolumeMapper draws, to a fraction of a voxel
 *
 * Pick casts the same ray as the mapper, and so returns the very point that is visible. Volumes
 * with other mappers, and actors, are ignored. Of several volumes the nearest to the camera is
 * picked.
 */
#ifndef vtkSubVoxelPicker_h
#define vtkSubVoxelPicker_h

#include "PalpateVolumeRenderingModule.h" // For export macro
#include "vtkAbstractPropPicker.h"

class PALPATEVOLUMERENDERING_EXPORT vtkSubVoxelPicker : public vtkAbstractPropPicker
{
public:
  static vtkSubVoxelPicker* New();
  vtkTypeMacro(vtkSubVoxelPicker, vtkAbstractPropPicker);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using Superclass::Pick;
  /**
   * Picks at a position of the window (pixels; z is not used). Returns 1 if a surface was hit; the
   * point is then the PickPosition (mm, world).
   */
  int Pick(double x, double y, double z, vtkRenderer* renderer) override;

  ///@{
  /** Result of the last pick: the material, -1 if nothing was hit, and the outward unit normal. */
  vtkGetMacro(Material, int);
  vtkGetVector3Macro(Normal, double);
  ///@}

protected:
  vtkSubVoxelPicker() = default;
  ~vtkSubVoxelPicker() override = default;

private:
  vtkSubVoxelPicker(const vtkSubVoxelPicker&) = delete;
  void operator=(const vtkSubVoxelPicker&) = delete;

  int Material = -1;
  double Normal[3] = {0.0, 0.0, 0.0};
};

#endif
