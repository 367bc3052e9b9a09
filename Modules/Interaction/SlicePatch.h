#pragma once

#include "PalpateInteractionModule.h"
#include "PixelGrid.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTexture.h"

#include <vector>

namespace palpate
{
/// A flat, unlit, textured polygon in 3D: the pixels of a grid at their positions, within a convex
/// polygon of its plane.
class PALPATEINTERACTION_EXPORT SlicePatch
{
public:
  SlicePatch();

  /// The image to show; paint into it, then place it.
  vtkImageData* RasterImage() const { return this->Pixels; }
  /// Corners in order, world, mm.
  void Place(const PixelGrid& grid, const std::vector<Vector3>& cornersWorld);
  /// The corners of the whole image.
  static std::vector<Vector3> CornersOf(const PixelGrid& grid);
  /// Whether to interpolate between pixels: not if they coincide with those of the screen.
  void SetInterpolate(bool interpolate);

  vtkActor* Actor() const { return this->Polygon; }

private:
  vtkNew<vtkImageData> Pixels;
  vtkNew<vtkTexture> Texture;
  vtkNew<vtkPolyData> Shape;
  vtkNew<vtkActor> Polygon;
};
} // namespace palpate
