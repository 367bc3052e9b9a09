#pragma once

#include "RandomShapes.h"
#include "SurfaceModel.h"

#include <cmath>

namespace palpate::test
{
/// A hand that wanders over a surface, in and out of it, and sometimes jumps 5 mm.
class WanderingHand
{
public:
  WanderingHand(const SurfaceModel& surface, double toolRadius, Random& random)
      : Surface(surface), ToolRadius(toolRadius), Source(random), Parameter(RandomDirection(random))
  {
  }

  Vector3 Next()
  {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    this->Axis = (this->Axis + 0.1 * RandomDirection(this->Source)).normalized();
    this->Parameter = (Eigen::AngleAxisd(0.004, this->Axis) * this->Parameter).normalized();
    this->Jump = uniform(this->Source) < 0.001 ? Vector3(5.0 * RandomDirection(this->Source))
                                               : Vector3(0.95 * this->Jump);
    ++this->Tick;
    const double height = -0.5 + 1.0 * std::sin(0.013 * this->Tick) + 0.1 * std::sin(0.7 * Tick);
    return this->Surface.Point(this->Parameter) +
           (this->ToolRadius + height) * this->Surface.Normal(this->Parameter) + this->Jump;
  }
  bool IsJumping() const { return this->Jump.norm() > 0.01; }

private:
  const SurfaceModel& Surface;
  double ToolRadius;
  Random& Source;
  Vector3 Parameter;
  Vector3 Axis = Vector3::UnitX();
  Vector3 Jump = Vector3::Zero();
  long Tick = 0;
};
} // namespace palpate::test
