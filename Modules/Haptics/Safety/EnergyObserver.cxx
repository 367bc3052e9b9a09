#include "EnergyObserver.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Shortened so that it does not turn a push (a force or a torque) into its opposite.
Vector3 WithoutPull(const Vector3& damping, const Vector3& push) noexcept
{
  const double square = push.squaredNorm();
  if (!(square > 0.0))
  {
    return Vector3::Zero();
  }
  const double along = damping.dot(push) / square;
  return along < -1.0 ? Vector3(damping - (along + 1.0) * push) : damping;
}
} // namespace

void EnergyObserver::Account(const ToolWrench& wrench, const Twist& path) noexcept
{
  const double taken = -wrench.Force.dot(path.Shift) - wrench.Torque.dot(path.Turn);
  this->Balance += std::isfinite(taken) ? taken : 0.0;
}

void EnergyObserver::Credit(double energy) noexcept
{
  this->Balance += energy > 0.0 && std::isfinite(energy) ? energy : 0.0;
}

ToolWrench EnergyObserver::Damping(const ToolWrench& contact, const Twist& velocity,
                                   double period) noexcept
{
  const double perTurn = this->TurnLength * this->TurnLength;
  const double square = velocity.Shift.squaredNorm() + perTurn * velocity.Turn.squaredNorm();
  if (!(this->Balance < 0.0) || !(square > 0.0) || !std::isfinite(square) || !(period > 0.0))
  {
    return {};
  }
  const double wanted = -this->Balance / (period * square);
  const double damping = std::min(wanted, this->LargestDamping);
  return {WithoutPull(-damping * velocity.Shift, contact.Force),
          WithoutPull(-damping * perTurn * velocity.Turn, contact.Torque)};
}
} // namespace palpate
