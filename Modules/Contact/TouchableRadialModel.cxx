#include "TouchableRadialModel.h"

#include "RadiusRange.h"
#include "UnprovenPoint.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
bool IsFinite(const RadialModel& model)
{
  const auto& coefficients = model.Coefficients();
  return model.CenterWorld().allFinite() && std::all_of(coefficients.begin(), coefficients.end(),
                                                        [](double c) { return std::isfinite(c); });
}

double MeanRadius(const RadialModel& model)
{
  return model.Coefficients()[0] / std::sqrt(4.0 * M_PI);
}
} // namespace

Status TouchableRadialModel::Make(std::shared_ptr<const RadialModel> model,
                                  std::shared_ptr<const TouchableRadialModel>& surface)
{
  if (!IsFinite(*model))
  {
    return Status::Failure("The model to be touched has numbers that are not finite.");
  }
  // Finer than any use of the extremes; relative to the size, so that units do not matter.
  constexpr double Tolerance = 1e-4;
  const double size = MeanRadius(*model);
  if (!(size > 0.0))
  {
    return Status::Failure("The model to be touched has no positive mean radius.");
  }
  const RadiusRange range = FindRadiusRange(*model, Tolerance * size);
  if (!(range.Lower > 0.0))
  {
    return Status::Failure("The surface to be touched reaches its centre: its radius must be "
                           "positive in every direction.");
  }
  surface.reset(new TouchableRadialModel(std::move(model), range.Lower, range.Upper));
  return Status::Success();
}

TouchableRadialModel::TouchableRadialModel(std::shared_ptr<const RadialModel> model,
                                           double smallest, double largest)
    : Closest(std::move(model)), Smallest(smallest), Largest(largest)
{
}

TouchableRadialModel::Place TouchableRadialModel::PlaceAt(const Vector3& direction) const noexcept
{
  const RadialModel::Sample sample = this->Model().Evaluate(direction);
  const Vector3 surface = sample.Radius * direction;
  return {direction, this->Model().CenterWorld() + surface,
          (surface - sample.SurfaceGradient).normalized()};
}

ClosestPoint TouchableRadialModel::PointAt(const Vector3& direction,
                                           const Vector3& queryWorld) const noexcept
{
  return UnprovenPoint(this->Model(), direction, queryWorld);
}
} // namespace palpate
