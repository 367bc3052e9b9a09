#include "RigidProxy.h"

#include "TurnBetween.h"

namespace palpate
{
Twist RigidProxy::TowardsHand(const ToolPose& hand) const noexcept
{
  return {hand.PositionWorld - this->Now.PositionWorld,
          TurnBetween(this->Now.Orientation, hand.Orientation)};
}

// As far as nothing can be, since a distance changes by no more than the way; where something is
// near, short enough for planes to stand for surfaces.
double RigidProxy::LongestWay(double nearest, const Twist& twist, double turned) const noexcept
{
  const double longest = std::max(Stride, 0.9 * (nearest - Margin));
  const double turn = twist.Turn.norm();
  if (this->ContactCount() == 0 || turn * this->Extent <= 0.0)
  {
    return longest;
  }
  return std::min(longest, std::max(FastestTurn - turned, 0.0) / turn * this->WayOf(twist));
}

// What the last step left too deep is mended in full, unless that would lead to walls that are not
// in the way.
void RigidProxy::KeepWithin(double longest, Twist& twist) noexcept
{
  const double way = this->WayOf(twist);
  if (way > longest)
  {
    this->Limits.ForgetPushes();
    twist = this->Limits.Solve({longest / way * twist.Shift, longest / way * twist.Turn},
                               this->TurnLength);
    const double mended = this->WayOf(twist);
    const double most = longest + 0.9 * (InTheWay - Stride);
    if (mended > most)
    {
      twist = {most / mended * twist.Shift, most / mended * twist.Turn};
    }
  }
}

void RigidProxy::Move(const Twist& twist) noexcept
{
  this->Now.PositionWorld += twist.Shift;
  this->Now.Orientation = TurnedBy(twist.Turn, this->Now.Orientation);
}

ToolWrench RigidProxy::WrenchOn(const ToolPose& hand, double stiffness) const noexcept
{
  const Twist back = this->TowardsHand(hand);
  const double length = this->TurnLength;
  return {-stiffness * back.Shift, -stiffness * length * length * back.Turn};
}

double RigidProxy::EnergyOf(const ToolPose& hand, double stiffness) const noexcept
{
  const Twist back = this->TowardsHand(hand);
  const double length = this->TurnLength;
  return 0.5 * stiffness * (back.Shift.squaredNorm() + length * length * back.Turn.squaredNorm());
}

std::size_t RigidProxy::ContactCount() const noexcept
{
  return static_cast<std::size_t>(std::count_if(this->Solved.begin(), this->Solved.end(),
                                                [](const auto& at) { return at.Push > 0.0; }));
}
} // namespace palpate
