#pragma once

#include "SteeringSource.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Events of spacenavd, the daemon of six-axis caps (spacenav.sourceforge.net), as its clients of
/// protocol version 0 receive them: eight integers of 32 bits in the machine's order. The first is
/// the kind: 0 motion (then x, y, z and turns about them, y upwards and z away from the person, and
/// a period), 1 a button pressed, 2 released (then its number). Others are left out.
class SpnavEvents
{
public:
  /// An axis at full deflection, by the daemon's default sensitivity.
  static constexpr double FullDeflection = 350.0;

  /// Bytes as they arrived; what is left of an event waits for the next ones.
  void Take(const std::uint8_t* bytes, std::size_t count) noexcept;
  const SteeringInput& Input() const noexcept { return this->Newest; }

private:
  using Event = std::array<std::int32_t, 8>;

  void Take(const Event& event) noexcept;

  SteeringInput Newest;
  std::array<std::uint8_t, sizeof(Event)> Part{};
  std::size_t Known = 0; // bytes of Part
};
} // namespace palpate
