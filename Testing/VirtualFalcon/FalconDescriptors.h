#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate::test
{
/// USB descriptors of a virtual Falcon. The values are those of an FT232R with the Falcon's product
/// number; they were never compared with a real Falcon.
struct FalconDescriptors
{
  static constexpr std::uint16_t Vendor = 0x0403;
  static constexpr std::uint16_t Product = 0xcb48;

  std::string Serial = "VF000001"; ///< ASCII

  /// Device and configuration descriptor, one after the other, as usbfs and sysfs show them
  /// (Universal Serial Bus Specification 2.0, 9.6).
  std::array<std::uint8_t, 50> Bytes() const;
  /// String descriptor `index`; empty if there is none.
  std::vector<std::uint8_t> String(std::uint8_t index) const;
};
} // namespace palpate::test
