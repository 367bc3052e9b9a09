#pragma once

#include "PalpateInteractionModule.h"
#include "ViewProps.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"

#include <array>

class vtkPolyData;

namespace palpate
{
/// The silhouette of a surface in 3D: lines of about the same width where it turns away from the
/// viewer, at its rim and within. It is found per pixel by a shader, so it needs no geometry of its
/// own and follows a surface that changes.
class PALPATEINTERACTION_EXPORT SurfaceOutline : public ViewProps
{
public:
  SurfaceOutline();

  /// `surface` has normals; null hides it. `width` in pixels. `isSeenThrough`: it is also drawn,
  /// faint, over what hides it.
  void Update(vtkPolyData* surface, const std::array<double, 3>& color, double width,
              bool isSeenThrough);

private:
  struct Drawn
  {
    vtkNew<vtkPolyDataMapper> Mapper;
    vtkNew<vtkActor> Actor;
  };
  void Make(Drawn& drawn);

  Drawn Line;
  Drawn Ghost;
};
} // namespace palpate
