#include "HandoverLimit.h"

#include "FadingContact.h"
#include "TurnBetween.h"

#include <algorithm>

namespace palpate
{
namespace
{
// By how much a motion goes along a direction.
double Along(const Vector3& motion, const Vector3& direction) noexcept
{
  const double size = direction.norm();
  return size > 0.0 ? motion.dot(direction) / size : 0.0;
}
} // namespace

ToolWrench HandoverLimit::Limited(const ToolWrench& wrench, double stiffness, double gyration,
                                  const Vector3& hand, const Eigen::Quaterniond& turn,
                                  double passed) noexcept
{
  if (this->IsOver())
  {
    return wrench;
  }
  const double shifted = Along(this->Hand - hand, wrench.Force);
  const double turned = gyration * Along(TurnBetween(turn, this->Turn), wrench.Torque);
  this->Hand = hand;
  this->Turn = turn;
  return {this->OfForce.Limited(wrench.Force, stiffness * (shifted + 0.5 * turned), passed),
          this->OfTorque.Limited(wrench.Torque, stiffness * gyration * (turned + 0.5 * shifted),
                                 passed)};
}

Vector3 HandoverLimit::Part::Limited(const Vector3& value, double raised, double passed) noexcept
{
  if (!this->IsActive)
  {
    return value;
  }
  // While two contacts fade into each other, a force may fall before it rises.
  constexpr double Enough = 2.0 * HandoverDuration;
  const double size = value.norm();
  this->Most = std::max(0.0, this->Most + raised);
  this->Unneeded = size <= this->Most ? this->Unneeded + passed : 0.0;
  this->IsActive = this->Unneeded < Enough;
  return size > this->Most ? Vector3((this->Most / size) * value) : value;
}
} // namespace palpate
