#pragma once

#include "PalpateInteractionModule.h"
#include "SurfaceCut.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <array>
#include <vector>

namespace palpate
{
/// Curves in space (mm), unlit lines that cannot be picked.
class PALPATEINTERACTION_EXPORT CurveActor
{
public:
  CurveActor();

  /// Moved by `lift`, towards the viewer, which changes only the drawing order.
  void SetCurves(const std::vector<SurfaceCurve>& curves, const Vector3& lift);
  /// `width` in pixels.
  void SetStyle(const std::array<double, 3>& color, double opacity, double width);
  void SetVisible(bool isVisible);

  vtkActor* Actor() const { return this->Lines; }
  vtkPolyData* Data() const { return this->Curves; }

private:
  vtkNew<vtkPolyData> Curves;
  vtkNew<vtkActor> Lines;
};
} // namespace palpate
