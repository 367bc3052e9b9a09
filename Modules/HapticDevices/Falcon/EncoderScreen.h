#pragma once

#include "FalconPackets.h"

#include <cstdint>

namespace palpate
{
/// Rejects physically implausible encoder counts: a reply corrupted in transit may still be well
/// formed. Counts that deviate from the line through the last two by more than any acceleration can
/// explain are accepted only if the next ones continue from there. So a single wrong reply never
/// moves the grip, and a real jump (a stop, encoders that were zeroed) arrives one reply late.
/// Deviations within the tolerance pass: half a millimetre at the grip.
///
/// Servo thread only. Counters may wrap round at 16 bits.
class EncoderScreen
{
public:
  /// At `time` (ns), which must increase. Returns false if the counts are not, or not yet,
  /// accepted.
  bool Believes(const FalconNumbers& counts, std::int64_t time) noexcept;
  /// The next counts are unrelated to the last ones.
  void Restart() noexcept { *this = {}; }

private:
  struct Reading
  {
    FalconNumbers Counts{};
    std::int64_t Time = 0;
    bool IsThere = false;
  };
  bool GoesOn(const Reading& reading) const noexcept;
  static bool AreNear(const Reading& from, const Reading& to) noexcept;

  Reading Last;
  Reading Before;
  Reading Doubtful;
};
} // namespace palpate
