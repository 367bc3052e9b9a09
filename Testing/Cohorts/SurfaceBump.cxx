#include "SurfaceBump.h"

#include <cmath>
#include <utility>

namespace palpate::test
{
SurfaceBump::SurfaceBump(RadialModel mean, const Vector3& place, double height, double extent)
    : Mean(std::move(mean)), Direction(place), PlacePoint(Mean.Radius(place) * place), Peak(height),
      Width(extent)
{
}

double SurfaceBump::DistanceOf(const Vector3& direction) const
{
  return (this->Mean.Radius(direction) * direction - this->PlacePoint).norm();
}

bool SurfaceBump::Covers(const Vector3& direction) const
{
  return this->DistanceOf(direction) < 0.5 * this->Width;
}

double SurfaceBump::AlongNormal(const Vector3& direction) const
{
  const double distance = this->DistanceOf(direction);
  const double cosine =
      distance < 0.5 * this->Width ? std::cos(M_PI * distance / this->Width) : 0.0;
  return this->Peak * cosine * cosine;
}

double SurfaceBump::AlongRadius(const Vector3& direction) const
{
  return this->AlongNormal(direction) / this->Mean.Normal(direction).dot(direction);
}
} // namespace palpate::test
