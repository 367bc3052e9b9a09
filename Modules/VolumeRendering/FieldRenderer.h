#pragma once

#include "ContactMark.h"
#include "FieldImage.h"
#include "PalpateVolumeRenderingModule.h"
#include "PixelRays.h"
#include "RayCaster.h"
#include "SurfaceShading.h"

#include <Eigen/Geometry>
#include <memory>
#include <vector>

namespace palpate
{
/// Appearance of the surface of one material.
struct MaterialLook
{
  Vector3 Color = Vector3(0.9, 0.85, 0.75); ///< 0..1
  double Opacity = 1.0;                     ///< 0..1; 0 hides the material
};

/// All parameters of an image of a field. The field's own world (patient LPS, mm) may be placed
/// elsewhere in the scene: rays and clips are in the former, lights in the latter.
struct FieldView
{
  PixelRays Rays;                                 ///< in the field's world
  std::vector<Eigen::Hyperplane<double, 3>> Kept; ///< clipping planes: their positive sides
  std::vector<MaterialLook> Looks; ///< by material; missing ones have the default appearance
  SurfaceFinish Finish;
  std::vector<SurfaceLight> Lights;
  ContactMark Contact;                                   ///< on any material near it
  Eigen::Matrix4d ToScene = Eigen::Matrix4d::Identity(); ///< from the field's world
  /// Depths, by pixel, of props already drawn, which end the rays; empty if there are none.
  std::vector<float> SceneDepths;
};

/// Draws a field by the first hits of its rays: the hits are RayCaster's, so the image shows the
/// surface that haptic queries touch. Const; any number of threads may draw tiles at once.
class PALPATEVOLUMERENDERING_EXPORT FieldRenderer
{
public:
  FieldRenderer(std::shared_ptr<const ScalarField> field, FieldView view);

  const FieldView& View() const noexcept { return this->Scene; }
  /// Whether every pixel shows only its nearest surface.
  bool IsOpaque() const noexcept { return this->Opaque; }

  /// The nearest visible surface on the ray through a point of the image, in pixels (see
  /// PixelRays); a miss if there is none.
  FieldHit FirstHitAt(double x, double y) const noexcept;
  /// Fills the pixels of `picture` (of the view's size) with column0 <= column < column1 and
  /// row0 <= row < row1.
  void DrawTile(int column0, int column1, int row0, int row1, FieldImage& raster) const noexcept;

private:
  // Rays that are cast together.
  struct Beam;

  double ClearBeam(int column0, int column1, int row0, int row1, double from) const noexcept;
  RayInterval ShownInterval(const FieldRay& ray) const noexcept;
  RayInterval IntervalOf(const FieldRay& ray, std::size_t pixel, double from) const noexcept;
  Vector3 ColorOf(const FieldHit& hit, const Vector3& toEyeScene) const noexcept;
  void DrawBeam(int column0, int column1, int row0, int row1, double from, Beam& beam,
                FieldImage& raster) const noexcept;
  void DrawPixel(const FieldRay& ray, RayInterval interval, FieldHit& hit, std::size_t pixel,
                 FieldImage& raster) const noexcept;

  RayCaster Caster;
  FieldView Scene;
  MaterialSet Shown = 0;
  Eigen::Matrix3d VectorToScene;
  Eigen::Matrix3d NormalToScene;
  SurfaceShading Shading;
  bool NeedsPoints; ///< whether colours depend on the position of a hit in the scene
  bool Opaque = true;
};
} // namespace palpate
