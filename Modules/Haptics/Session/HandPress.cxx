#include "HandPress.h"

namespace palpate
{
namespace
{
// mm that a hand at rest may move: two steps of a Falcon's encoders.
constexpr double Still = 0.1;
// Ticks: the servo has to have taken the lift; a slow hand is no longer on its way; and where one
// does not arrive, friction holds it.
constexpr std::uint64_t TicksOfLift = 5;
constexpr std::uint64_t TicksOfRest = 10;
constexpr std::uint64_t TicksOfStop = 100;
} // namespace

void HandPress::Await(const Vector3& restDevice, std::uint64_t tick)
{
  this->Waits = true;
  this->Goal = restDevice;
  this->First = tick;
}

bool HandPress::Take(const TouchState& tick)
{
  if (!tick.HasSample)
  {
    return false;
  }
  const std::uint64_t now = tick.Tick.Number;
  const Vector3 hand(tick.Sample.Position);
  if ((hand - this->StillAt).norm() > Still || now < this->StillSince)
  {
    this->StillAt = hand;
    this->StillSince = now;
  }
  if (!this->Waits)
  {
    return false;
  }
  const std::uint64_t still = now - this->StillSince;
  const bool isThere = still >= TicksOfRest && (hand - this->Goal).norm() < Hover - Still;
  const bool isStopped = still >= TicksOfStop && now >= this->First + TicksOfStop;
  if (now < this->First + TicksOfLift || (!isThere && !isStopped))
  {
    return false;
  }
  this->Waits = false;
  return true;
}
} // namespace palpate
