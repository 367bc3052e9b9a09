#pragma once

#include "PalpateVolumeRenderingModule.h"

#include "vtkProp.h"

#include <memory>

class vtkOpenGLQuadHelper;

namespace palpate
{
/// The graded background of a renderer, drawn where nothing else is: VTK's ambient occlusion
/// replaces that which VTK itself has drawn by one colour.
class PALPATEVOLUMERENDERING_EXPORT GradedGround : public vtkProp
{
public:
  static GradedGround* New();
  vtkTypeMacro(GradedGround, vtkProp);

  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  GradedGround();
  ~GradedGround() override;

private:
  GradedGround(const GradedGround&) = delete;
  void operator=(const GradedGround&) = delete;

  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};
} // namespace palpate
