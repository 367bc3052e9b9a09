#include "ElasticBed.h"

#include "SmoothStep.h"

#include "Units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
bool IsStiffness(double stiffness) noexcept
{
  constexpr double Most = 1e3; // N/mm^3
  return stiffness >= 0.0 && stiffness <= Most;
}
} // namespace

void ElasticBed::Free(const Vector3& axis, double halfAngle)
{
  this->FreeCones.push_back({axis.normalized(), halfAngle});
}

void ElasticBed::Hold(std::function<double(const Vector3&)> part, double stiffness)
{
  this->Holders.push_back({std::move(part), stiffness});
}

Status ElasticBed::Check() const
{
  const bool areStiffnesses =
      IsStiffness(this->Stiffness) &&
      std::all_of(this->Holders.begin(), this->Holders.end(),
                  [](const Holder& holder) { return IsStiffness(holder.Stiffness); });
  if (!areStiffnesses)
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

double ElasticBed::At(const Vector3& direction) const
{
  constexpr double Rim = 1.0 / 6.0; // rad
  double part = 1.0;
  for (const Cone& cone : this->FreeCones)
  {
    const double angle = std::acos(std::clamp(direction.dot(cone.Axis), -1.0, 1.0));
    const double t = std::clamp((angle - cone.HalfAngle) / Rim, 0.0, 1.0);
    part *= SmoothStep(t);
  }
  double stiffness = this->Stiffness * part;
  for (const Holder& holder : this->Holders)
  {
    stiffness += std::clamp(holder.Part(direction), 0.0, 1.0) * (holder.Stiffness - stiffness);
  }
  return stiffness;
}
} // namespace palpate
