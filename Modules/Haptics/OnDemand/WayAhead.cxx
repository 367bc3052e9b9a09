#include "WayAhead.h"

namespace palpate
{
namespace
{
// What was fast or slow is forgotten by this part with each look or delay.
constexpr double Forgotten = 0.02;

double Forget(double before, double now) noexcept
{
  return std::max(now, (1.0 - Forgotten) * before);
}
} // namespace

void WayAhead::Look(const ToolPlace& place) noexcept
{
  const double passed = this->Last ? place.Time - this->Last->Time : 0.0;
  const double speed =
      passed > 0.0 ? (place.ProbeWorld - this->Last->ProbeWorld).norm() / passed : 0.0;
  this->Speed = std::max(this->PromisedSpeed, Forget(this->Speed, speed));
  this->Last = place;
}

void WayAhead::Made(double delay) noexcept
{
  this->SlowestDelay = std::max(this->LeastDelay, Forget(this->SlowestDelay, delay));
}
} // namespace palpate
