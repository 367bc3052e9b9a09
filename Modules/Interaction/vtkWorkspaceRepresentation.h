/**
 * @class vtkWorkspaceRepresentation
 * @brief a haptic device's workspace in linked views
 *
 * 3D views show the edges of its box, slices the outline of its cross-section. Set the corners
 * before views are drawn; non-finite numbers are ignored, and the last valid values are kept.
 */
#ifndef vtkWorkspaceRepresentation_h
#define vtkWorkspaceRepresentation_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For the box

class vtkPolyData;

class PALPATEINTERACTION_EXPORT vtkWorkspaceRepresentation : public vtkObject
{
public:
  static vtkWorkspaceRepresentation* New();
  vtkTypeMacro(vtkWorkspaceRepresentation, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The corners of the workspace: world, mm. `corners` has 8 times x, y, z, in the order of VTK's
   * voxels: the device's x runs fastest, its z slowest.
   */
  void SetCorners(const double corners[24]);
  /** One of them, from 0 to 7. */
  void GetCorner(int number, double world[3]);
  /** The box as a closed surface of triangles. Do not change. */
  vtkPolyData* GetBox();

  ///@{
  /** Red, green, blue. Default: Okabe and Ito's reddish purple. */
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  ///@}
  ///@{
  /** Off by default, since no workspace is known. */
  vtkSetMacro(Visibility, bool);
  vtkGetMacro(Visibility, bool);
  vtkBooleanMacro(Visibility, bool);
  ///@}

protected:
  vtkWorkspaceRepresentation();
  ~vtkWorkspaceRepresentation() override;

private:
  vtkWorkspaceRepresentation(const vtkWorkspaceRepresentation&) = delete;
  void operator=(const vtkWorkspaceRepresentation&) = delete;

  vtkSmartPointer<vtkPolyData> Box;
  double Color[3] = {0.8, 0.47, 0.65};
  bool Visibility = false;
};

#endif
