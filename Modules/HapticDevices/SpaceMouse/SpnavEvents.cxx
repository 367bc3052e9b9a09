#include "SpnavEvents.h"

#include <algorithm>
#include <cstring>

namespace palpate
{
namespace
{
enum Kind : std::int32_t
{
  Motion = 0,
  Press = 1,
  Release = 2
};

double PartOfFull(std::int32_t axis) noexcept
{
  return std::clamp(axis / SpnavEvents::FullDeflection, -1.0, 1.0);
}
} // namespace

void SpnavEvents::Take(const std::uint8_t* bytes, std::size_t count) noexcept
{
  while (count > 0)
  {
    const std::size_t taken = std::min(count, this->Part.size() - this->Known);
    std::memcpy(this->Part.data() + this->Known, bytes, taken);
    this->Known += taken;
    bytes += taken;
    count -= taken;
    if (this->Known == this->Part.size())
    {
      Event event;
      std::memcpy(event.data(), this->Part.data(), sizeof(event));
      this->Take(event);
      this->Known = 0;
    }
  }
}

void SpnavEvents::Take(const Event& event) noexcept
{
  const auto button = static_cast<std::uint32_t>(event[1]);
  const std::uint32_t bit = button < 32 ? std::uint32_t{1} << button : 0;
  switch (event[0])
  {
  case Motion:
    this->Newest.Push = Vector3(PartOfFull(event[1]), PartOfFull(event[2]), -PartOfFull(event[3]));
    this->Newest.Turn = Vector3(PartOfFull(event[4]), PartOfFull(event[5]), -PartOfFull(event[6]));
    break;
  case Press:
    this->Newest.Buttons |= bit;
    break;
  case Release:
    this->Newest.Buttons &= ~bit;
    break;
  default:
    break;
  }
}
} // namespace palpate
