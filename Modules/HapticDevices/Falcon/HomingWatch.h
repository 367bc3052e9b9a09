#pragma once

#include "FalconPackets.h"

namespace palpate
{
/// Decides from the replies' bits whether all encoders are homed. A single reply decides nothing,
/// since a byte of it may be wrong, and positions are accepted only some replies after the last
/// jump.
class HomingWatch
{
public:
  enum class Verdict
  {
    Waiting, ///< the handle must be pulled out and pushed in
    Homed,
    Lost ///< it is no longer homed
  };

  Verdict Take(unsigned homedBits) noexcept
  {
    const bool isHomed = homedBits == FalconReply::AllHomed;
    this->InARow = isHomed == this->WasHomed ? this->InARow + 1 : 1;
    this->WasHomed = isHomed;
    if (isHomed && this->InARow >= RepliesToSettle)
    {
      this->Result = Verdict::Homed;
    }
    if (!isHomed && this->InARow >= RepliesToLose && this->Result == Verdict::Homed)
    {
      this->Result = Verdict::Lost;
    }
    return this->Result;
  }

private:
  static constexpr int RepliesToSettle = 20;
  static constexpr int RepliesToLose = 3;

  bool WasHomed = false;
  int InARow = 0;
  Verdict Result = Verdict::Waiting;
};
} // namespace palpate
