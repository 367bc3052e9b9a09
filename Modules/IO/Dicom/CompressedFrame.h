#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// One frame of compressed grey pixels, and the pixel format that its header declares:
/// little-endian words of `BytesPerPixel` bytes, the values in the bits up to `HighBit`.
struct CompressedFrame
{
  std::vector<std::uint8_t> Stream;
  int Columns = 0;
  int Rows = 0;
  int BytesPerPixel = 0; ///< 1, 2 or 4
  int BitsStored = 0;
  int HighBit = 0; ///< at least BitsStored - 1
  bool IsSigned = false;

  std::size_t PixelCount() const
  {
    return static_cast<std::size_t>(this->Columns) * static_cast<std::size_t>(this->Rows);
  }

  /// Stores a decoded sample of `precision` bits (1 to 8 BytesPerPixel) in `pixels`. If the stream
  /// is too narrow to reach the high bit, its samples are the values themselves.
  void Store(std::uint32_t sample, int precision, std::size_t pixel, std::uint8_t* pixels) const
  {
    if (precision <= this->HighBit)
    {
      const bool isNegative = this->IsSigned && ((sample >> (precision - 1)) & 1U) != 0;
      sample = isNegative ? sample | (~std::uint32_t{0} << precision) : sample;
      sample <<= this->HighBit + 1 - this->BitsStored;
    }
    const auto size = static_cast<std::size_t>(this->BytesPerPixel);
    for (std::size_t byte = 0; byte < size; ++byte)
    {
      pixels[pixel * size + byte] = static_cast<std::uint8_t>(sample >> (8 * byte));
    }
  }
};
} // namespace palpate
