#include "RigidProxy.h"

namespace palpate
{
namespace
{
// From `from` to `to`, on the shorter way: rad, in the world.
Vector3 RotationBetween(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) noexcept
{
  const Eigen::AngleAxisd turn(to * from.conjugate());
  const double angle = turn.angle() > EIGEN_PI ? turn.angle() - 2.0 * EIGEN_PI : turn.angle();
  return angle * turn.axis();
}
} // namespace

Twist RigidProxy::TowardsHand(const ToolPose& hand) const noexcept
{
  return {hand.PositionWorld - this->Now.PositionWorld,
          RotationBetween(this->Now.Orientation, hand.Orientation)};
}

void RigidProxy::KeepPushes() noexcept
{
  std::fill(this->Pushes.begin(), this->Pushes.end(), 0.0);
  for (std::size_t n = 0; n < this->Limits.Size(); ++n)
  {
    this->Pushes[this->Limits[n].Source] = this->Limits[n].Push;
  }
}

void RigidProxy::Move(const Twist& twist) noexcept
{
  this->Now.PositionWorld += twist.Shift;
  const double angle = twist.Turn.norm();
  if (angle > 0.0)
  {
    this->Now.Orientation =
        (Eigen::AngleAxisd(angle, twist.Turn.normalized()) * this->Now.Orientation).normalized();
  }
}

ToolWrench RigidProxy::WrenchOn(const ToolPose& hand, double stiffness) const noexcept
{
  const Twist back = this->TowardsHand(hand);
  const double length = this->Tool.Gyration();
  return {-stiffness * back.Shift, -stiffness * length * length * back.Turn};
}

double RigidProxy::EnergyOf(const ToolPose& hand, double stiffness) const noexcept
{
  const Twist back = this->TowardsHand(hand);
  const double length = this->Tool.Gyration();
  return 0.5 * stiffness * (back.Shift.squaredNorm() + length * length * back.Turn.squaredNorm());
}

std::size_t RigidProxy::ContactCount() const noexcept
{
  return static_cast<std::size_t>(std::count_if(this->Pushes.begin(), this->Pushes.end(),
                                                [](double push) { return push > 0.0; }));
}
} // namespace palpate
