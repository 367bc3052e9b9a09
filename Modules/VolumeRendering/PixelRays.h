#pragma once

#include "PalpateVolumeRenderingModule.h"
#include "RayCaster.h"

#include <Eigen/LU>

namespace palpate
{
/// The rays through the pixels of an image, and the depths of points on them. The only source of
/// rays, so that image, picker and tests use the same bits.
class PALPATEVOLUMERENDERING_EXPORT PixelRays
{
public:
  PixelRays() = default;
  /// `worldToClip` maps homogeneous world points (mm) to -1..1 across the image and to 0 at the
  /// near plane and 1 at the far plane, as vtkCamera's composite matrix does for that range.
  PixelRays(const Eigen::Matrix4d& worldToClip, int width, int height);

  int Width() const noexcept { return this->Columns; }
  int Height() const noexcept { return this->Rows; }
  /// Whether the matrix is invertible.
  bool IsUsable() const noexcept { return this->Usable; }

  /// From the near plane (t = 0) to the far plane (t = 1). x and y in pixels from the lower left
  /// corner; pixel (i, j) has its centre at (i + 0.5, j + 0.5).
  FieldRay At(double x, double y) const noexcept;
  FieldRay OfPixel(int column, int row) const noexcept { return this->At(column + 0.5, row + 0.5); }
  /// Depth buffer value, 0 at the near plane and 1 at the far plane.
  double Depth(const Vector3& pointWorld) const noexcept;
  /// The parameter of a ray at which the depth buffer value is `depth`.
  double ParameterAtDepth(const FieldRay& ray, double depth) const noexcept;

private:
  int Columns = 0;
  int Rows = 0;
  bool Usable = false;
  Eigen::Matrix4d ToClip = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d ToWorld = Eigen::Matrix4d::Identity();
};
} // namespace palpate
