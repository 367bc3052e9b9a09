#include "DrillFeed.h"

#include <algorithm>
#include <cmath>

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

// Cuts that no version contains yet; summed from scratch, so that no rounding remains of those that
// have arrived.
double DrillFeed::MostAhead() const noexcept
{
  double ahead = this->Play + this->Unordered;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    ahead += this->Waiting[(this->First + i) % MostWaiting].Path;
  }
  return ahead;
}

Vector3 DrillFeed::Meet(const ToolPose& probe, const Vector3& offset, bool cuts) noexcept
{
  constexpr double KeptInTick = 0.95; // of the play, while nothing is cut
  const double length = offset.norm();
  const Vector3 proxy = probe.PositionWorld + offset;
  this->Play = cuts ? this->Clearance : KeptInTick * this->Play;
  double ahead = -this->Play;
  if (this->IsTouching && length > 0.0)
  {
    const Vector3 out = offset / length;
    const Vector3 path = this->Tool - proxy;
    ahead = -path.dot(out);
    const double below = std::max(ahead + this->Clearance, 0.0);
    ahead -= (path + ahead * out).norm() * std::sqrt(2.0 * below / this->Radius);
    ahead = std::clamp(ahead, -this->Play, std::min(this->MostAhead(), length));
  }
  this->IsTouching = true;
  this->Probe = probe;
  this->Remaining = length > 0.0 ? Vector3((1.0 - ahead / length) * offset) : Vector3::Zero();
  this->Tool = probe.PositionWorld + this->Remaining;
  return this->Remaining;
}

double DrillFeed::Advance(double path) noexcept
{
  const double length = this->Remaining.norm();
  const double went = this->Count < MostWaiting ? std::clamp(path, 0.0, length) : 0.0;
  if (!this->IsCutting)
  {
    this->IsCutting = true;
    this->TicksSinceCut = 0;
    this->LastCut = Plain(this->Tool, this->Probe.Orientation);
  }
  this->Tool -= (length > 0.0 ? went / length : 0.0) * this->Remaining;
  this->Unordered += went;
  return went;
}

void DrillFeed::Rest() noexcept
{
  this->IsCutting = false;
  this->Unordered = 0.0;
}

void DrillFeed::Leave() noexcept
{
  this->Rest();
  this->Play = 0.0;
  this->IsTouching = false;
}

bool DrillFeed::NextCut(CutOrder& order) noexcept
{
  if (!this->IsCutting || ++this->TicksSinceCut < TicksOfCut || this->Count == MostWaiting ||
      !(this->Unordered > 0.0))
  {
    return false;
  }
  order.To = Plain(this->Tool, this->Probe.Orientation);
  const bool isNear = (this->Tool - Vector3(this->LastCut.PositionWorld)).norm() <= this->Radius;
  order.From = isNear ? this->LastCut : order.To;
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
