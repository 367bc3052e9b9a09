#pragma once

#include <cstdint>
#include <cstring>

namespace palpate
{
/// The version that a header of the library begins with, in this machine's byte order. OpenIGTLink
/// 3 has another name for the field.
template <typename Header>
int IgtlHeaderVersion(const Header& header) noexcept
{
  std::uint16_t version = 0;
  std::memcpy(&version, &header, sizeof version);
  return version;
}
} // namespace palpate
