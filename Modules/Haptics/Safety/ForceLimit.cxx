#include "ForceLimit.h"

#include "ClampedLength.h"

namespace palpate
{
Vector3 ForceLimit::Apply(const Vector3& force) noexcept
{
  Vector3 limited = ClampedLength(force, this->Maximum);
  this->Limiting = limited != force;
  return limited;
}
} // namespace palpate
