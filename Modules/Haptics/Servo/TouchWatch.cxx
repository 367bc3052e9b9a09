#include "TouchWatch.h"

namespace palpate
{
void TouchWatch::Take(const TouchState& tick, std::vector<TouchChange>& changes)
{
  using Kind = TouchChange::Kind;
  TouchChange change;
  change.Time = tick.Tick.Started;
  const auto add = [&](Kind kind)
  {
    change.What = kind;
    changes.push_back(change);
  };
  if (tick.Structure != this->Structure)
  {
    change.Structure = this->Structure;
    if (this->Structure >= 0)
    {
      add(Kind::ContactEnds);
    }
    change.Structure = tick.Structure;
    if (tick.Structure >= 0)
    {
      add(Kind::ContactBegins);
    }
    this->Structure = tick.Structure;
  }
  const std::uint32_t buttons = tick.HasSample ? tick.Sample.Buttons : this->Buttons;
  for (std::uint32_t left = buttons ^ this->Buttons, button = 0; left != 0; left >>= 1, ++button)
  {
    if ((left & 1U) != 0)
    {
      change.Button = static_cast<int>(button);
      add((buttons >> button & 1U) != 0 ? Kind::ButtonPressed : Kind::ButtonReleased);
    }
  }
  this->Buttons = buttons;
  if (tick.Safety.Fault != this->Fault)
  {
    change.Why = tick.Safety.Fault;
    change.WillResume = tick.Safety.WillResume;
    add(tick.Safety.Fault != SafetyFault::None ? Kind::Fault : Kind::ForcesOn);
    this->Fault = tick.Safety.Fault;
  }
}
} // namespace palpate
