#pragma once

#include "Status.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// The image that a Falcon runs after power-up. It is Novint's and comes from the user's own disk:
/// none is part of Palpate.
///
/// A file is recognised by its structure, that of a boot stream for TI's serial loader (TMS320x281x
/// Boot ROM Reference Guide, SPRU095): words of 16 bits, least byte first; the key 0x08AA, eight
/// reserved words, the entry address (high word first); blocks of a size in words, a destination
/// (high word first) and that many words; a size of 0 as the last word.
class FalconFirmware
{
public:
  /// What the processor's memory holds at most, with what the stream adds.
  static constexpr std::size_t LargestSize = 65536;

  /// Fails with a sentence that names the file and what is wrong with it.
  static Status Read(const std::string& path, FalconFirmware& firmware);
  /// Of bytes; `name` is what the sentence calls them.
  static Status Parse(std::vector<std::uint8_t> bytes, const std::string& name,
                      FalconFirmware& firmware);
  /// The file to use: `chosen` where it is not empty, else what the environment's
  /// PALPATE_FALCON_FIRMWARE names; empty where neither says anything.
  static std::string PathOf(const std::string& chosen);

  const std::string& Name() const noexcept { return this->Label; }
  const std::vector<std::uint8_t>& Bytes() const noexcept { return this->Image; }

private:
  std::string Label;
  std::vector<std::uint8_t> Image;
};
} // namespace palpate
