#include "EnergyObserver.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
void EnergyObserver::Account(const Vector3& force, const Vector3& path) noexcept
{
  const double taken = -force.dot(path);
  this->Balance += std::isfinite(taken) ? taken : 0.0;
}

void EnergyObserver::Credit(double energy) noexcept
{
  this->Balance += energy > 0.0 && std::isfinite(energy) ? energy : 0.0;
}

Vector3 EnergyObserver::Damping(const Vector3& contactForce, const Vector3& velocity,
                                double period) noexcept
{
  const double square = velocity.squaredNorm();
  if (!(this->Balance < 0.0) || !(square > 0.0) || !std::isfinite(square) || !(period > 0.0))
  {
    return Vector3::Zero();
  }
  const double wanted = -this->Balance / (period * square);
  Vector3 damping = -std::min(wanted, this->LargestDamping) * velocity;
  const double push = contactForce.squaredNorm();
  if (!(push > 0.0))
  {
    return Vector3::Zero();
  }
  // Relative to the contact's force.
  const double along = damping.dot(contactForce) / push;
  if (along < -1.0)
  {
    damping -= (along + 1.0) * contactForce;
  }
  return damping;
}
} // namespace palpate
