#include "DeviceState.h"

namespace palpate
{
const char* NameOf(DeviceState state) noexcept
{
  switch (state)
  {
  case DeviceState::Closed:
    return "closed";
  case DeviceState::Opening:
    return "opening";
  case DeviceState::Homing:
    return "homing";
  case DeviceState::Ready:
    return "ready";
  case DeviceState::Error:
    break;
  }
  return "error";
}
} // namespace palpate
