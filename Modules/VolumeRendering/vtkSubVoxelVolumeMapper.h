/**
 * @class vtkSubVoxelVolumeMapper
 * @brief draws the surfaces of a field exactly where a haptic tool would touch them
 *
 * For each pixel palpate::RayCaster, which haptic queries use too, finds the first surface on its
 * ray, which is shaded by the analytic gradient. Each iso-value of the input image (one component,
 * any numeric type; origin, spacing in mm and direction are honoured) defines one material, which
 * includes all higher values. Alternatively SetField sets an existing field with any materials, and
 * no input is needed.
 *
 * Colour and opacity belong to the material; shading (on or off, ambient, diffuse, specular and its
 * power) is the vtkVolumeProperty's, whose transfer functions are not used. Translucent surfaces
 * are blended from front to back. Clipping planes (world) cut the surfaces open; VTK's cropping
 * regions are ignored.
 *
 * The image has depths, so the surface and other props hide each other correctly. For translucent
 * polygons see vtkSubVoxelVolume. Rays are cast by vtkSMPTools; the image does not depend on the
 * number of threads. If a frame would take longer than the renderer allows, as while the camera
 * moves, fewer rays are cast, and all of them at rest. Raises VolumeMapperRender events; checks for
 * an abort between bands of rows. While the field is built it raises progress events, and the
 * window's abort or AbortExecute cancels that; the build restarts when the field is next requested.
 *
 * Errors: an image that FieldBuilder refuses raises an ErrorEvent with its message, and nothing is
 * drawn.
 */
#ifndef vtkSubVoxelVolumeMapper_h
#define vtkSubVoxelVolumeMapper_h

#include "PalpateVolumeRenderingModule.h" // For export macro
#include "vtkVolumeMapper.h"

#include <memory> // For std::shared_ptr

class vtkRenderWindow;

namespace palpate
{
class FieldRenderer;
class ScalarField;
struct ContactMark;
struct FieldImage;
} // namespace palpate

class PALPATEVOLUMERENDERING_EXPORT vtkSubVoxelVolumeMapper : public vtkVolumeMapper
{
public:
  static vtkSubVoxelVolumeMapper* New();
  vtkTypeMacro(vtkSubVoxelVolumeMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum InterpolationTypes
  {
    TRILINEAR, ///< faster
    TRICUBIC   ///< B-spline: normals without creases
  };

  ///@{
  /** The iso-values of the input image, one material each. Default: none. */
  void SetNumberOfIsoValues(int count);
  int GetNumberOfIsoValues();
  void SetIsoValue(int material, double value);
  ///@}

  ///@{
  /** Interpolation between the nodes of the input image. Default: TRILINEAR. */
  void SetInterpolation(int interpolation);
  vtkGetMacro(Interpolation, int);
  ///@}

#ifndef __VTK_WRAP__
  /** Draws an existing field instead of the input; null returns to the input. */
  void SetField(std::shared_ptr<const palpate::ScalarField> field);
  /** The field that is drawn, built if necessary; null if it cannot be built. */
  std::shared_ptr<const palpate::ScalarField> GetField();
#endif

  ///@{
  /** Red, green, blue and opacity of a material, 0 to 1. Opacity 0 hides it; default 1. */
  void SetMaterialColor(int material, double red, double green, double blue);
  void GetMaterialColor(int material, double color[3]);
  void SetMaterialOpacity(int material, double opacity);
  double GetMaterialOpacity(int material);
  ///@}
#ifndef __VTK_WRAP__
  ///@{
  /** A line of this width (pixels) and colour around the surfaces. Default: 0, none. */
  vtkSetClampMacro(OutlineWidth, double, 0.0, 20.0);
  vtkGetMacro(OutlineWidth, double);
  vtkSetVector3Macro(OutlineColor, double);
  vtkGetVector3Macro(OutlineColor, double);
  ///@}
  /** Where the surface is coloured differently; see ContactMark. Default: nowhere. */
  void SetContact(const palpate::ContactMark& contact);
#endif
  /** Whether no visible material is translucent. */
  bool IsOpaque();

  ///@{
  /**
   * Whether rays may be fewer than pixels so that a frame takes no longer than the renderer allows.
   * On by default. ImageSampleDistance is the distance of rays in pixels if this is off, and
   * reports that of the last frame, at most 4, if it is on.
   */
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  vtkSetClampMacro(ImageSampleDistance, double, 1.0, 64.0);
  vtkGetMacro(ImageSampleDistance, double);
  ///@}

  ///@{
  /** Whether the last frame's image keeps each pixel's hit. Off by default. */
  vtkSetMacro(KeepHits, bool);
  vtkGetMacro(KeepHits, bool);
  vtkBooleanMacro(KeepHits, bool);
  ///@}
#ifndef __VTK_WRAP__
  ///@{
  /** The last frame: the image, and its rays. Null before the first. */
  const palpate::FieldImage* GetImage() const
  {
    return this->RasterImage.get();
  }
  const palpate::FieldRenderer* GetFieldRenderer() const
  {
    return this->Caster.get();
  }
  ///@}

  /** A visible surface point at a position of the window; world of the scene, mm. */
  struct SurfacePoint
  {
    double Position[3];
    double Normal[3]; ///< outward, unit
    double Depth;     ///< 0 at the near plane, 1 at the far plane
    int Material;
  };
  /** The surface on the ray of the window's pixel (x, y); returns false if there is none. */
  bool PickSurface(vtkRenderer* renderer, vtkVolume* volume, double x, double y,
                   SurfacePoint& point);
#endif

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSubVoxelVolumeMapper();
  ~vtkSubVoxelVolumeMapper() override;

private:
  vtkSubVoxelVolumeMapper(const vtkSubVoxelVolumeMapper&) = delete;
  void operator=(const vtkSubVoxelVolumeMapper&) = delete;

  /** `window`, if not null, can abort it. */
  bool UpdateField(vtkRenderWindow* window);
  double ChooseSampleDistance(vtkVolume* volume, double pixels);
  std::unique_ptr<palpate::FieldRenderer> MakeRenderer(vtkRenderer* renderer, vtkVolume* volume,
                                                       int width, int height,
                                                       bool readsSceneDepths);
  bool CastRays(vtkRenderer* renderer);

  int Interpolation = TRILINEAR;
  bool AutoAdjustSampleDistances = true;
  double ImageSampleDistance = 1.0;
  bool KeepHits = false;
  double OutlineWidth = 0.0;
  double OutlineColor[3] = {1.0, 1.0, 1.0};

  struct State;
  std::unique_ptr<State> Inner;
  std::unique_ptr<palpate::FieldImage> RasterImage;
  std::unique_ptr<palpate::FieldRenderer> Caster;
};

#endif
