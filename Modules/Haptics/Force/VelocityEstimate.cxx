#include "VelocityEstimate.h"

namespace palpate
{
void VelocityEstimate::Reset() noexcept
{
  this->HasLast = false;
  this->Filtered.setZero();
}

const Vector3& VelocityEstimate::Update(const Vector3& position, double period) noexcept
{
  const Vector3 difference = (position - this->Last) / period;
  // The exact step response would use an exponential; this filter's gain is at most 1 too.
  const double weight = period / (this->TimeConstant + period);
  const Vector3 next = this->Filtered + weight * (difference - this->Filtered);
  const bool isUsable = this->HasLast && period > 0.0 && next.allFinite();
  this->Filtered = isUsable ? next : Vector3::Zero();
  this->Last = position;
  this->HasLast = position.allFinite();
  return this->Filtered;
}
} // namespace palpate
