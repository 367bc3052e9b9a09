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
class vtkSubVoxelVolumeMapper;
class vtkTextActor;
class vtkUnsignedCharArray;

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
  /// Returns the surface's number, from 0, for MoveSurface.
  std::size_t AddSurface(vtkPolyData* surface, const Color& color, double opacity);
  /// Draws the surface displaced by `pathWorld` (mm) from its original position, which alone
  /// decides the extent of the image.
  void MoveSurface(std::size_t surface, const Vector3& pathWorld);
  /// Draws the sub-voxel surfaces of a field's materials by the ray caster that haptic queries use.
  /// One colour per material. Returns the field's number, from 0, for ChangeField.
  std::size_t AddField(const std::shared_ptr<const ScalarField>& field,
                       const std::vector<Color>& colors, double opacity);
  /// Replaces a field by another version with the same materials.
  void ChangeField(std::size_t number, const std::shared_ptr<const ScalarField>& field);
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
  /// The same into an existing image, at its size and without allocating memory.
  void Render(const ViewFrame& frame, RasterImage& raster);

private:
  struct Surface
  {
    vtkSmartPointer<vtkActor> Actor;
    vtkSmartPointer<vtkPolyData> Data;
  };

  std::array<double, 2> RangeOf(const std::string& name) const;
  void PlaceCamera(const ViewFrame& frame, double aspect);
  void AddLetters();
  void SetLetters(const ViewFrame& frame);
  void AddColorBar();
  void RemoveAnnotations();
  void AddAnnotations(int width, int height);
  void Annotate(vtkProp* prop);
  Color InkColor() const;
  int FontSize(double referenceSize) const;

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  std::vector<Surface> Surfaces;
  std::vector<vtkSmartPointer<vtkSubVoxelVolumeMapper>> Fields;
  std::vector<Vector3> Outline;                         ///< points that must be visible, mm
  std::vector<vtkSmartPointer<vtkProp>> Annotations;    ///< of the last rendered image
  std::array<vtkSmartPointer<vtkTextActor>, 4> Letters; ///< left, right, top, bottom
  vtkSmartPointer<vtkUnsignedCharArray> Pixels;
  Color Background{{1.0, 1.0, 1.0}};
  std::string ColoredArray;
  vtkSmartPointer<vtkScalarsToColors> BarColors;
};
} // namespace palpate
