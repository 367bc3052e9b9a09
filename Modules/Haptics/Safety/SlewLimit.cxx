#include "SlewLimit.h"

#include "ClampedLength.h"

namespace palpate
{
Vector3 SlewLimit::Apply(const Vector3& force, double period) noexcept
{
  const Vector3 wanted = force.allFinite() ? force : Vector3::Zero();
  const Vector3 change = wanted - this->Last;
  const Vector3 allowed = ClampedLength(change, this->Rate * period);
  this->Slewing = allowed != change;
  // If not limited, exactly the wanted force.
  this->Last = this->Slewing ? Vector3(this->Last + allowed) : wanted;
  return this->Last;
}
} // namespace palpate
