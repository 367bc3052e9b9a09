#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// How long something took, many times: a histogram of fixed size with sixteen classes an octave,
/// so that adding costs the same for ever and allocates nothing. A copy is a snapshot; snapshots of
/// several stretches or threads merge into what one would have counted.
class PeriodStatistics
{
public:
  /// One duration, ns; a negative one counts as 0.
  void Add(std::int64_t duration) noexcept;
  /// Deadlines that were not kept.
  void AddMisses(std::uint64_t count) noexcept { this->MissCount += count; }
  void Merge(const PeriodStatistics& other) noexcept;

  std::uint64_t Count() const noexcept { return this->Total; }
  std::uint64_t Misses() const noexcept { return this->MissCount; }
  /// ns; 0 where nothing was added.
  std::int64_t Min() const noexcept { return this->Total > 0 ? this->Least : 0; }
  std::int64_t Max() const noexcept { return this->Largest; }
  double Mean() const noexcept;
  /// The duration (ns) that the share `fraction` in [0, 1] of all did not exceed: never less than
  /// the exact one, and at most a sixteenth more. 0 where nothing was added.
  std::int64_t Quantile(double fraction) const noexcept;
  std::int64_t Median() const noexcept { return this->Quantile(0.5); }

private:
  static constexpr int ClassBits = 4;
  // Durations below 16 ns have a class each, then come 59 octaves.
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
