#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace palpate::test
{
/// A boot stream in the loader's format with random words, in place of the firmware, of which the
/// tests contain no byte. `words` >= 1 in `blocks` >= 1 blocks.
inline std::vector<std::uint8_t> BootStream(std::size_t words = 200, std::size_t blocks = 3,
                                            std::uint64_t seed = 1)
{
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> bytes;
  const auto word = [&bytes](std::uint64_t value)
  {
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFFU));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8U & 0xFFU));
  };
  word(0x08AA);
  for (int reserved = 0; reserved < 8; ++reserved)
  {
    word(0);
  }
  word(0x003F);
  word(0x8002);
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const std::size_t size = words / blocks + (block < words % blocks ? 1 : 0);
    if (size > 0)
    {
      word(size);
      word(0x003F);
      word(0x8000 + 0x400 * block);
      for (std::size_t i = 0; i < size; ++i)
      {
        word(random());
      }
    }
  }
  word(0);
  return bytes;
}
} // namespace palpate::test
