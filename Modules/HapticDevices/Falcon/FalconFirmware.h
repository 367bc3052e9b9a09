#pragma once

#include "Status.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// The image that a Falcon runs after power-up. It is Novint's and comes from the user's own disk;
/// Palpate contains none.
///
/// A file is recognised by its structure, that of a boot stream for TI's serial loader (TMS320x281x
/// Boot ROM Reference Guide, SPRU095): words of 16 bits, little endian; the key 0x08AA, eight
/// reserved words, the entry address (high word first); blocks of a size in words, a destination
/// (high word first) and that many words; a size of 0 as the last word.
class FalconFirmware
{
public:
  /// Size of the processor's memory, plus the overhead of the stream.
  static constexpr std::size_t LargestSize = 65536;

  /// Fails with a message that names the file and its error.
  static Status Read(const std::string& path, FalconFirmware& firmware);
  /// From bytes; `name` denotes them in error messages.
  static Status Parse(std::vector<std::uint8_t> bytes, const std::string& name,
                      FalconFirmware& firmware);
  /// The file to use: `chosen` if not empty, otherwise the environment's PALPATE_FALCON_FIRMWARE;
  /// empty if neither is set.
  static std::string PathOf(const std::string& chosen);

  const std::string& Name() const noexcept { return this->Label; }
  const std::vector<std::uint8_t>& Bytes() const noexcept { return this->Image; }

private:
  std::string Label;
  std::vector<std::uint8_t> Image;
};
} // namespace palpate
