#include "HandoverLimit.h"

#include "FadingContact.h"

#include <algorithm>

namespace palpate
{
Vector3 HandoverLimit::Limited(const Vector3& force, double stiffness, const Vector3& hand,
                               double passed) noexcept
{
  if (this->IsOver())
  {
    return force;
  }
  const double size = force.norm();
  if (size > 0.0)
  {
    const double pushed = (this->Hand - hand).dot(force) / size;
    this->Most = std::max(0.0, this->Most + stiffness * pushed);
  }
  this->Hand = hand;
  // While two contacts fade into each other, a force may fall before it rises.
  constexpr double Enough = 2.0 * HandoverDuration;
  this->Unneeded = size <= this->Most ? this->Unneeded + passed : 0.0;
  this->IsActive = this->Unneeded < Enough;
  return size > this->Most ? Vector3((this->Most / size) * force) : force;
}
} // namespace palpate
