#pragma once

#include "FalconPackets.h"

#include <cstdint>

namespace palpate
{
/// Keeps counts away that no hand can have made: a reply whose bytes were changed on the way may
/// still look like one. Counts that lie off the line through the last two by more than any
/// acceleration can explain are believed only if the next ones go on from there. So a single wrong
/// reply never moves the grip, and a real jump (a stop, encoders that were given a zero) comes one
/// reply late. What is within the tolerance passes: half a millimetre at the grip.
///
/// All on the servo thread. Counters that wrap round at 16 bits are followed.
class EncoderScreen
{
public:
  /// At `time` (ns), which grows. False where they are not believed, or not yet.
  bool Believes(const FalconNumbers& counts, std::int64_t time) noexcept;
  /// The next counts have nothing to do with the last ones.
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
