#pragma once

#include "AnatomicalView.h"
#include "PalpateSceneModule.h"
#include "RasterImage.h"
#include "ScalarField.h"

#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkImageData;
class vtkPolyData;
class vtkProp;
class vtkRenderer;
class vtkRenderWindow;
class vtkScalarsToColors;

namespace palpate
{
/// Draws surfaces and slices of volumes in space (patient LPS, mm) with VTK, off screen: parallel
/// projection, letters of the patient's directions at the edges of the image, and a colour bar if
/// surfaces are coloured by an array. The constructor throws std::runtime_error without a display,
/// see RequireDisplay.
class PALPATESCENE_EXPORT SceneRenderer
{
public:
  using Color = std::array<double, 3>; ///< 0..1

  enum class Plane
  {
    Sagittal,
    Coronal,
    Axial
  };

  SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;
  ~SceneRenderer();

  void SetBackground(const Color& color);
  void AddSurface(vtkPolyData* surface, const Color& color, double opacity);
  /// Draws the sub-voxel surfaces of a field's materials by the ray caster that haptic queries use.
  /// One colour per material.
  void AddField(const std::shared_ptr<const ScalarField>& field, const std::vector<Color>& colors,
                double opacity);
  /// The slice of a volume (with its direction matrix) through a point, along the image's axis
  /// that is nearest to the body's.
  void AddSlice(vtkImageData* volume, Plane plane, const Vector3& throughWorld);
  /// Colours every surface that has this one-component point array, all on one scale: diverging
  /// around zero if it has both signs, otherwise starting at white. Returns false if no surface has
  /// it.
  bool ColorByArray(const std::string& name);
  /// The one-component point arrays of all surfaces.
  std::vector<std::string> ArrayNames() const;

  /// Centre of the objects added so far, mm.
  Vector3 CenterWorld() const;

  /// Renders the scene along a frame, as large as it fits.
  RasterImage Render(const ViewFrame& frame, int width, int height);

private:
  struct Surface
  {
    vtkSmartPointer<vtkActor> Actor;
    vtkSmartPointer<vtkPolyData> Data;
  };

  std::array<double, 2> RangeOf(const std::string& name) const;
  void PlaceCamera(const ViewFrame& frame, double aspect);
  void AddLetters(const ViewFrame& frame);
  void AddColorBar();
  void RemoveAnnotations();
  void Annotate(vtkProp* prop);
  Color InkColor() const;
  int FontSize(double referenceSize) const;

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  std::vector<Surface> Surfaces;
  std::vector<Vector3> Outline;                      ///< points that must be visible, mm
  std::vector<vtkSmartPointer<vtkProp>> Annotations; ///< of the last rendered image
  Color Background{{1.0, 1.0, 1.0}};
  std::string ColoredArray;
  vtkSmartPointer<vtkScalarsToColors> BarColors;
};
} // namespace palpate
