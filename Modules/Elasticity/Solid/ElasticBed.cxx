#include "ElasticBed.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
void ElasticBed::Free(const Vector3& axis, double halfAngle)
{
  this->FreeCones.push_back({axis.normalized(), halfAngle});
}

Status ElasticBed::Check() const
{
  constexpr double MostStiffness = 1e3; // N/mm^3
  constexpr double Pi = 3.14159265358979323846;
  if (!(this->Stiffness >= 0.0 && this->Stiffness <= MostStiffness))
  {
    return Status::Failure("The bed's stiffness is not a number from 0 to 1000 N/mm^3.");
  }
  const bool areCones =
      std::all_of(this->FreeCones.begin(), this->FreeCones.end(),
                  [](const Cone& cone) {
                    return cone.Axis.allFinite() && cone.HalfAngle > 0.0 && cone.HalfAngle <= Pi;
                  });
  return areCones ? Status::Success()
                  : Status::Failure("The part that is left free has no direction, or an angle that "
                                    "is not between 0 and 180 degrees.");
}

double ElasticBed::At(const Vector3& direction) const noexcept
{
  constexpr double Rim = 1.0 / 6.0; // rad
  double part = 1.0;
  for (const Cone& cone : this->FreeCones)
  {
    const double angle = std::acos(std::clamp(direction.dot(cone.Axis), -1.0, 1.0));
    const double t = std::clamp((angle - cone.HalfAngle) / Rim, 0.0, 1.0);
    part *= t * t * (3.0 - 2.0 * t);
  }
  return this->Stiffness * part;
}
} // namespace palpate
