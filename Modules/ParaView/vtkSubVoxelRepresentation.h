#ifndef vtkSubVoxelRepresentation_h
#define vtkSubVoxelRepresentation_h

#include "PalpateParaViewModule.h"
#include "vtkNew.h"
#include "vtkPVDataRepresentation.h"
#include "vtkSmartPointer.h"

class vtkImageData;
class vtkSubVoxelVolume;
class vtkSubVoxelVolumeMapper;
class vtkVolumeProperty;

/// Draws an image in ParaView's render view as one surface of a sub-voxel field: where it passes a
/// value, ray by ray, without triangles (vtkSubVoxelVolumeMapper). The image's active point scalars
/// count.
class PALPATEPARAVIEW_EXPORT vtkSubVoxelRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkSubVoxelRepresentation* New();
  vtkTypeMacro(vtkSubVoxelRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The surface passes between values below this and values of at least this.
  void SetIsoValue(double value);
  /// vtkSubVoxelVolumeMapper::InterpolationTypes.
  void SetInterpolation(int interpolation);
  /// Red, green, blue, 0 to 1.
  void SetSurfaceColor(double red, double green, double blue);
  void SetSurfaceOpacity(double opacity);
  void SetSpecular(double specular);

  void SetVisibility(bool isVisible) override;
  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* input,
                         vtkInformation* output) override;

protected:
  vtkSubVoxelRepresentation();
  ~vtkSubVoxelRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkSubVoxelRepresentation(const vtkSubVoxelRepresentation&) = delete;
  void operator=(const vtkSubVoxelRepresentation&) = delete;

  vtkNew<vtkSubVoxelVolumeMapper> Mapper;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkSubVoxelVolume> Volume;
  vtkSmartPointer<vtkImageData> Image; ///< the input image; null without input
};

#endif
