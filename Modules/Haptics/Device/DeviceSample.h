#pragma once

#include "PlainVector3.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace palpate
{
/// One measurement of a device, in its own frame.
struct DeviceSample
{
  PlainVector3 Position; ///< mm
  /// x, y, z, w of the unit quaternion from the tool's to the device's frame; the identity if the
  /// device does not measure it.
  std::array<double, 4> Orientation{0.0, 0.0, 0.0, 1.0};
  std::uint32_t Buttons = 0;  ///< one bit each, set while pressed
  std::uint64_t Sequence = 0; ///< increases with every new measurement, and only then
  std::int64_t Time = 0;      ///< ns of the servo's clock

  /// A finite position, and an orientation of unit length.
  bool IsPose() const noexcept
  {
    constexpr double FarFromUnit = 1e-3; // of the square; protocols send seven digits
    double square = 0.0;
    for (const double part : this->Orientation)
    {
      square += part * part;
    }
    // Written so that NaN fails it.
    return std::isfinite(this->Position.X) && std::isfinite(this->Position.Y) &&
           std::isfinite(this->Position.Z) && std::abs(square - 1.0) <= FarFromUnit;
  }
};
} // namespace palpate
