#include "FalconDescriptors.h"

namespace palpate::test
{
std::array<std::uint8_t, 50> FalconDescriptors::Bytes() const
{
  // Two-byte numbers are little endian.
  return {// Device: USB 2.00, class by interface, 8 bytes at endpoint 0, ids, release 6.00, strings
          // 1 to
          // 3, one configuration.
          18, 1, 0x00, 0x02, 0, 0, 0, 8, 0x03, 0x04, 0x48, 0xcb, 0x00, 0x06, 1, 2, 3, 1,
          // Configuration 1: 32 bytes in total, one interface, bus powered, 90 mA.
          9, 2, 32, 0, 1, 1, 0, 0xa0, 45,
          // Interface 0: two endpoints, vendor's class.
          9, 4, 0, 0, 2, 0xff, 0xff, 0xff, 2,
          // Endpoints 0x81 and 0x02: bulk, 64 bytes.
          7, 5, 0x81, 2, 64, 0, 0, //
          7, 5, 0x02, 2, 64, 0, 0};
}

std::vector<std::uint8_t> FalconDescriptors::String(std::uint8_t index) const
{
  constexpr std::uint8_t Type = 3;
  if (index == 0)
  {
    return {4, Type, 0x09, 0x04}; // English of the United States
  }
  const std::array<std::string, 3> texts{"Virtual", "FALCON HAPTIC", this->Serial};
  if (index > texts.size())
  {
    return {};
  }
  const std::string& text = texts.at(index - 1U);
  std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(2 + 2 * text.size()), Type};
  for (const char letter : text)
  {
    bytes.push_back(static_cast<std::uint8_t>(letter));
    bytes.push_back(0);
  }
  return bytes;
}
} // namespace palpate::test
