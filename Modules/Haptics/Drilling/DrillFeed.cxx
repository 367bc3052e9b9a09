#include "DrillFeed.h"

#include <algorithm>

namespace palpate
{
namespace
{
PlainPose Plain(const Vector3& positionWorld, const Eigen::Quaterniond& orientation) noexcept
{
  return {positionWorld, {orientation.x(), orientation.y(), orientation.z(), orientation.w()}};
}
} // namespace

void DrillFeed::Arrive(std::uint64_t number) noexcept
{
  while (this->Count > 0 && this->Waiting[this->First].Number < number)
  {
    this->First = (this->First + 1) % MostWaiting;
    --this->Count;
  }
}

// Summed anew, so that nothing is left of what has arrived.
double DrillFeed::Ahead() const noexcept
{
  double ahead = this->Unordered;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    ahead += this->Waiting[(this->First + i) % MostWaiting].Way;
  }
  return ahead;
}

Vector3 DrillFeed::Remaining(const Vector3& offset) const noexcept
{
  const double length = offset.norm();
  const double ahead = this->Ahead();
  return ahead < length ? Vector3((1.0 - ahead / length) * offset) : Vector3::Zero();
}

double DrillFeed::Advance(const ToolPose& probe, const Vector3& remaining, double way) noexcept
{
  const double length = remaining.norm();
  const double went = this->Count < MostWaiting ? std::clamp(way, 0.0, length) : 0.0;
  if (!this->IsCutting)
  {
    this->IsCutting = true;
    this->TicksSinceCut = 0;
    this->LastCut = Plain(probe.PositionWorld + remaining, probe.Orientation);
  }
  const double part = length > 0.0 ? 1.0 - went / length : 0.0;
  this->Tool = Plain(probe.PositionWorld + part * remaining, probe.Orientation);
  this->Unordered += went;
  return went;
}

bool DrillFeed::NextCut(double apart, CutOrder& order) noexcept
{
  if (!this->IsCutting || ++this->TicksSinceCut < TicksOfCut || this->Count == MostWaiting ||
      !(this->Unordered > 0.0))
  {
    return false;
  }
  const Vector3 way = Vector3(this->Tool.PositionWorld) - Vector3(this->LastCut.PositionWorld);
  order.From = way.norm() <= apart ? this->LastCut : this->Tool;
  order.To = this->Tool;
  return true;
}

void DrillFeed::Ordered(const CutOrder& order) noexcept
{
  this->Waiting[(this->First + this->Count) % MostWaiting] = {order.Number, this->Unordered};
  ++this->Count;
  this->Unordered = 0.0;
  this->LastCut = order.To;
  this->TicksSinceCut = 0;
}
} // namespace palpate
