#pragma once

#include "OnDemandHarmonics.h"
#include "WayAhead.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace palpate
{
/// What became of a scene's structures of harmonics so far.
struct DegreeCounts
{
  std::uint64_t Brought = 0;
  std::uint64_t Dropped = 0;
  std::size_t MostBytes = 0; ///< at hand at once since the last Begin, without what is kept
  std::string Problem;       ///< why what is near is not at hand; empty where it is
};

/// Keeps the on-demand harmonics of a scene at hand where the tool is near, within one budget.
///
/// Look, Begin: one thread that is not the servo's. Counts: any.
class OnDemandDegrees
{
public:
  struct Settings
  {
    double ToolRadius = 0.0;      ///< mm, of the tool's bounding sphere
    std::size_t Room = 0;         ///< bytes for all that is at hand at once
    double PromisedSpeed = 100.0; ///< mm/s in the world, at least, that the tool may have
    double LeastDelay = 0.02;     ///< s, from a look until what it wanted is at hand
  };
  OnDemandDegrees(std::vector<std::shared_ptr<OnDemandHarmonics>> structures,
                  const Settings& settings);

  /// Drops all that nobody holds, so that what follows does not depend on what was before.
  void Begin();
  /// Bringing may take so long (s), as the making of the slowest ones tells.
  void Expect(double delay) noexcept { this->Ahead.Made(delay); }
  double SlowestMaking() const noexcept;

  /// Brings and drops what the tool's place asks; `now()` gives seconds, by the clock of `place`.
  template <typename Now>
  void Look(const ToolPlace& place, const Now& now)
  {
    if (this->Renew(place))
    {
      this->Ahead.Made(now() - place.Time);
    }
  }

  const std::vector<std::shared_ptr<OnDemandHarmonics>>& Structures() const noexcept
  {
    return this->All;
  }
  std::size_t Room() const noexcept { return this->Wanted.Room; }
  /// mm from a structure's box at which a tool that is not faster than promised has it brought.
  double NearFrom() const noexcept { return this->FirstWay; }
  /// Ticks that touched coarse bodies.
  std::uint64_t CoarseTicks() const noexcept;
  DegreeCounts Counts() const;

private:
  bool Renew(const ToolPlace& place);
  double AwayFrom(std::size_t one, const Vector3& placeWorld) const;
  bool AllAreAtHand(const Vector3& placeWorld) const;
  std::size_t BytesAtHand() const;
  void Drop(std::size_t one);
  bool Bring(std::size_t one, std::string& problem);
  void NoteProblem(const std::string& problem);

  std::vector<std::shared_ptr<OnDemandHarmonics>> All;
  Settings Wanted;
  WayAhead Ahead;
  double FirstWay = 0.0;
  std::vector<bool> IsLeaving; // asked back, and held
  mutable std::mutex Shared;   // by who asks: what follows
  DegreeCounts Known;
};
} // namespace palpate
