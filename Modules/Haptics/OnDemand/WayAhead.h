#pragma once

#include "Vector3.h"

#include <algorithm>
#include <optional>

namespace palpate
{
/// Where a tool is and when.
struct ToolPlace
{
  double Time = 0.0; ///< s
  Vector3 ProbeWorld = Vector3::Zero();
  Vector3 ProxyWorld = Vector3::Zero(); ///< the probe itself where nothing is touched

  ToolPlace() = default;
  ToolPlace(double time, const Vector3& probeWorld)
      : Time(time), ProbeWorld(probeWorld), ProxyWorld(probeWorld)
  {
  }
  bool IsFinite() const { return this->ProbeWorld.allFinite() && this->ProxyWorld.allFinite(); }
  /// How far probe or proxy went.
  double WayTo(const ToolPlace& other) const
  {
    return std::max((other.ProbeWorld - this->ProbeWorld).norm(),
                    (other.ProxyWorld - this->ProxyWorld).norm());
  }
};

/// How far ahead of a tool things have to be got ready: twice the way that it goes in the time that
/// this takes, at its speed and never less than the promised one. Knows no clock.
class WayAhead
{
public:
  /// mm/s in the world, at least, that the tool may have; s, at least, that getting ready takes.
  WayAhead(double promisedSpeed, double leastDelay)
      : PromisedSpeed(promisedSpeed), LeastDelay(leastDelay), SlowestDelay(leastDelay)
  {
  }

  /// The next look at the tool, which is at a finite place.
  void Look(const ToolPlace& place) noexcept;
  /// What was wanted is ready, so long (s) after the look that wanted it.
  void Made(double delay) noexcept;

  /// From where half of it is gone before more is wanted, mm.
  double Length() const noexcept { return 2.0 * this->Speed * this->SlowestDelay; }
  /// s; the slowest one, sinking slowly.
  double Delay() const noexcept { return this->SlowestDelay; }

private:
  double PromisedSpeed;
  double LeastDelay;
  double SlowestDelay;
  double Speed = 0.0; // mm/s, of the tool, sinking slowly
  std::optional<ToolPlace> Last;
};
} // namespace palpate
