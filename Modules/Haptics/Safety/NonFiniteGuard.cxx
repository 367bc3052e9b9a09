#include "NonFiniteGuard.h"

namespace palpate
{
Vector3 NonFiniteGuard::Apply(const Vector3& force) noexcept
{
  // Written so that NaN fails it.
  if ((force.array().abs() <= LargestSane).all())
  {
    return force;
  }
  this->Tripped = true;
  return Vector3::Zero();
}
} // namespace palpate
