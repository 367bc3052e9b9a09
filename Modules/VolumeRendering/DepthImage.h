#pragma once

#include "FieldImage.h"
#include "PalpateVolumeRenderingModule.h"
#include "Vector3.h"

#include "vtkNew.h"

#include <memory>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace palpate
{
/// Draws an image with depths over a renderer's viewport, pixel by pixel if it has the viewport's
/// size, so that it hides other props and is hidden by them. OpenGL; belongs to one window at a
/// time.
class PALPATEVOLUMERENDERING_EXPORT DepthImage
{
public:
  DepthImage();
  DepthImage(const DepthImage&) = delete;
  DepthImage& operator=(const DepthImage&) = delete;
  ~DepthImage();

  /// A line around what the image shows, as wide as these fractions of its width and height; 0, the
  /// default: none.
  void SetOutline(const Vector3& color, double across, double down);
  /// `writesDepths`: also hides props that are drawn later.
  void Draw(vtkRenderer* renderer, const FieldImage& raster, bool writesDepths);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Load(vtkOpenGLRenderWindow* window, const FieldImage& raster);

  vtkNew<vtkTextureObject> Colors;
  vtkNew<vtkTextureObject> Depths;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  float OutlineColor[3] = {0.0F, 0.0F, 0.0F};
  float OutlineReach[2] = {0.0F, 0.0F};
};
} // namespace palpate
