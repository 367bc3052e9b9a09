#pragma once

#include <cstdint>

namespace palpate
{
/// Decides how coarse models may have to be for ticks to fit into their period: the loop never
/// waits for a model. Level 0 is the scene as it was asked for, each next one is cheaper.
///
/// Two ticks of more than 70 % of the period within 50 ms, or two longer than it within a second,
/// raise the level at once: one alone may be the system's doing. It falls again after 2 s in which
/// no two ticks within 50 ms took more than 35 %; where that fails sooner than it had waited, it
/// waits twice as long the next time, up to 64 s, so that it does not flap.
///
/// Pure: knows no clock. Times are ns.
class TickBudget
{
public:
  explicit TickBudget(std::int64_t period) noexcept : Period(period) {}

  /// After each tick, which began at `started` and took `spent`; the scene has levels up to `most`.
  void Take(std::int64_t started, std::int64_t spent, int most) noexcept;
  /// Of the next tick.
  int Level() const noexcept { return this->Current; }

private:
  // Ticks of more than some part of the period, twice within some time.
  class Twice
  {
  public:
    bool Take(std::int64_t now, bool isLong, std::int64_t within) noexcept;

  private:
    std::int64_t Last = 0;
    bool HasLast = false;
  };

  void Raise(std::int64_t now) noexcept;
  void Lower(std::int64_t now) noexcept;

  static constexpr std::int64_t LeastPatience = 2'000'000'000;
  static constexpr std::int64_t MostPatience = 64'000'000'000;

  std::int64_t Period;
  Twice Crowded;
  Twice Late;
  Twice Busy;
  int Current = 0;
  std::int64_t Patience = LeastPatience;
  std::int64_t RoomSince = 0;
  std::int64_t Lowered = 0; // when
  bool WasLowered = false;
};
} // namespace palpate
