#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace palpate
{
/// Appends a number's bytes in little-endian order, as the binary surface formats require.
template <typename Number>
void AppendLittleEndian(std::string& bytes, Number value)
{
  static_assert(sizeof(Number) <= sizeof(std::uint64_t));
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof value);
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  bits >>= 8 * (sizeof bits - sizeof value);
#endif
  for (std::size_t i = 0; i < sizeof value; ++i)
  {
    bytes.push_back(static_cast<char>(bits >> (8 * i) & 0xff));
  }
}
} // namespace palpate
