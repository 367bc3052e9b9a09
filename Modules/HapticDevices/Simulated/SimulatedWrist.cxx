#include "SimulatedWrist.h"

#include "TurnBetween.h"

namespace palpate
{
void SimulatedWrist::Advance(const Eigen::Quaterniond& target, const Vector3& targetVelocity,
                             const Vector3& torque, double step) noexcept
{
  const Vector3 away = TurnBetween(this->Now, target);
  this->Now = TurnedBy(this->Held.Advance(away, targetVelocity, torque, step), this->Now);
}
} // namespace palpate
