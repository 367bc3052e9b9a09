/**
 * @class vtkSurfaceDisplay
 * @brief display of a surface in linked views: in 3D, and as a contour in slices
 *
 * The surface (world, patient LPS, mm) is shared by all views. With a color array, the 3D view
 * shows that array's values, such as a model's distances to its original, in colours suitable for
 * colour-blind people, with a colour bar; slices keep the plain colour.
 */
#ifndef vtkSurfaceDisplay_h
#define vtkSurfaceDisplay_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkObject.h"
#include "vtkPolyData.h" // For the surface
#include "vtkSmartPointer.h"

#include <string> // For the array's name

class PALPATEINTERACTION_EXPORT vtkSurfaceDisplay : public vtkObject
{
public:
  static vtkSurfaceDisplay* New();
  vtkTypeMacro(vtkSurfaceDisplay, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  vtkSetSmartPointerMacro(Surface, vtkPolyData);
  vtkGetSmartPointerMacro(Surface, vtkPolyData);
  ///@}

  ///@{
  /** Red, green, blue, 0 to 1. */
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  ///@}
  ///@{
  /** In 3D, 0 to 1; contours are opaque. */
  vtkSetClampMacro(Opacity, double, 0.0, 1.0);
  vtkGetMacro(Opacity, double);
  ///@}
  ///@{
  /** Whether it is shown at all. */
  vtkSetMacro(Visibility, bool);
  vtkGetMacro(Visibility, bool);
  vtkBooleanMacro(Visibility, bool);
  ///@}
  ///@{
  /** Whether slices show its contour. */
  vtkSetMacro(ContourVisibility, bool);
  vtkGetMacro(ContourVisibility, bool);
  vtkBooleanMacro(ContourVisibility, bool);
  ///@}
  ///@{
  /** Whether it is outlined in 3D and its contour is thicker, as what the user has selected. Off by
   * default. */
  vtkSetMacro(Highlight, bool);
  vtkGetMacro(Highlight, bool);
  vtkBooleanMacro(Highlight, bool);
  ///@}
  ///@{
  /** Whether it is outlined in red in 3D, also where something hides it, and its contour is red,
   * even if it is not visible otherwise: a tool must not touch it. Off by default. */
  vtkSetMacro(Forbidden, bool);
  vtkGetMacro(Forbidden, bool);
  vtkBooleanMacro(Forbidden, bool);
  ///@}
  ///@{
  /** Line width of contours, in points. */
  vtkSetClampMacro(LineWidth, double, 0.5, 20.0);
  vtkGetMacro(LineWidth, double);
  ///@}
  ///@{
  /** Whether 3D shows its edges only, as of a region that may be larger than the scene: they cannot
   * be picked, and the camera's reset leaves them out. Off by default. */
  vtkSetMacro(Wireframe, bool);
  vtkGetMacro(Wireframe, bool);
  vtkBooleanMacro(Wireframe, bool);
  ///@}
  ///@{
  /** Whether a point of it can be picked in 3D; if not, what is behind it. On by default. */
  vtkSetMacro(Pickable, bool);
  vtkGetMacro(Pickable, bool);
  vtkBooleanMacro(Pickable, bool);
  ///@}
  ///@{
  /** The one-component point array that colours it in 3D; empty for none, the default. */
  vtkSetStdStringFromCharMacro(ColorArray);
  vtkGetCharFromStdStringMacro(ColorArray);
  ///@}
  ///@{
  /** The array's value, and its negative, at the ends of the colours; 0, the default: by its
   * values. Surfaces coloured by arrays of one name share the widest scale. */
  vtkSetClampMacro(ColorLimit, double, 0.0, 1e300);
  vtkGetMacro(ColorLimit, double);
  ///@}

  /** The latest of its own time and that of the surface. */
  vtkMTimeType GetMTime() override;

protected:
  vtkSurfaceDisplay() = default;
  ~vtkSurfaceDisplay() override = default;

private:
  vtkSurfaceDisplay(const vtkSurfaceDisplay&) = delete;
  void operator=(const vtkSurfaceDisplay&) = delete;

  vtkSmartPointer<vtkPolyData> Surface;
  double Color[3] = {0.85, 0.72, 0.55};
  double Opacity = 1.0;
  bool Visibility = true;
  bool ContourVisibility = true;
  bool Highlight = false;
  bool Forbidden = false;
  double LineWidth = 1.5;
  bool Wireframe = false;
  bool Pickable = true;
  std::string ColorArray;
  double ColorLimit = 0.0;
};

#endif
