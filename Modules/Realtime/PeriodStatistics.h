#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Statistics of durations: a histogram of fixed size with sixteen bins per octave, so that adding
/// takes constant time and does not allocate. A copy is a snapshot.
class PeriodStatistics
{
public:
  /// One duration, ns; a negative one counts as 0.
  void Add(std::int64_t duration) noexcept;
  /// Adds missed deadlines.
  void AddMisses(std::uint64_t count) noexcept { this->MissCount += count; }

  std::uint64_t Count() const noexcept { return this->Total; }
  std::uint64_t Misses() const noexcept { return this->MissCount; }
  /// ns; 0 if empty.
  std::int64_t Min() const noexcept { return this->Total > 0 ? this->Least : 0; }
  std::int64_t Max() const noexcept { return this->Largest; }
  double Mean() const noexcept;
  /// The duration (ns) that a share `fraction` in [0, 1] of all durations did not exceed: never
  /// less than the exact quantile, and at most a sixteenth more. 0 if empty.
  std::int64_t Quantile(double fraction) const noexcept;
  std::int64_t Median() const noexcept { return this->Quantile(0.5); }

private:
  static constexpr int ClassBits = 4;
  // Durations below 16 ns have a bin each, followed by 59 octaves.
  static constexpr std::size_t ClassCount = std::size_t{60} << ClassBits;

  static std::size_t ClassOf(std::int64_t duration) noexcept;
  static std::int64_t LargestOf(std::size_t index) noexcept;

  std::array<std::uint64_t, ClassCount> Counts{};
  std::uint64_t Total = 0;
  std::uint64_t MissCount = 0;
  std::int64_t Least = INT64_MAX; // ns
  std::int64_t Largest = 0;       // ns
  double Sum = 0.0;               // ns
};
} // namespace palpate
