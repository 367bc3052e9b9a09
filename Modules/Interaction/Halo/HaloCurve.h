#pragma once

#include "CurveActor.h"

#include <algorithm>

namespace palpate
{
/// Curves in a slice with a dark rim, so that they are seen on any image.
class HaloCurve
{
public:
  /// See CurveActor; `lift` is that of a layer.
  void SetCurves(const std::vector<SurfaceCurve>& curves, const Vector3& lift)
  {
    constexpr double Under = 0.3; // mm below the curves, less than a layer
    this->Rim.SetCurves(curves, lift - Under * lift.normalized());
    this->Line.SetCurves(curves, lift);
  }
  void SetStyle(const std::array<double, 3>& color, double opacity, double width)
  {
    this->Rim.SetStyle({{0.0, 0.0, 0.0}}, opacity, width + std::max(2.0, 0.8 * width));
    this->Line.SetStyle(color, opacity, width);
  }

  std::array<vtkActor*, 2> Actors() const { return {{this->Rim.Actor(), this->Line.Actor()}}; }

private:
  CurveActor Rim;
  CurveActor Line;
};
} // namespace palpate
