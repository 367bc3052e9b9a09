#pragma once

#include "PalpateIOModule.h"

#include <cstdint>

namespace palpate
{
/// Reads the coded bits of a JPEG-LS scan (T.87, A.1): after a byte of 0xFF the next has seven
/// bits, unless it is a marker, which ends them.
class PALPATEIO_EXPORT JpegLsBits
{
public:
  JpegLsBits(const std::uint8_t* next, const std::uint8_t* end) : Next(next), End(end) {}

  /// The next `count` (0 to 32) bits, most significant first; 0 where they have ended.
  std::uint32_t Read(int count)
  {
    this->Fill(count);
    if (count == 0 || this->Ended)
    {
      return 0;
    }
    const auto value = static_cast<std::uint32_t>(this->Cache >> (64 - count));
    this->Drop(count);
    return value;
  }

  /// The number of zeros before the next one, which is passed. Gives up above `limit`.
  int ReadZeros(int limit)
  {
    int zeros = 0;
    while (zeros <= limit && !this->Ended && this->Read(1) == 0)
    {
      ++zeros;
    }
    return zeros;
  }

  /// True once more bits were asked for than there are.
  bool HasEnded() const { return this->Ended; }
  /// True where nothing but padding is left before the next marker.
  bool IsAtMarker() const;

private:
  void Drop(int count)
  {
    this->Cache <<= count;
    this->Available -= count;
  }
  // Makes `count` bits available.
  void Fill(int count);

  const std::uint8_t* Next;
  const std::uint8_t* End;
  std::uint64_t Cache = 0; // from its highest bit on
  int Available = 0;
  bool IsAfterFull = false; // after a byte of 0xFF
  bool Ended = false;
};
} // namespace palpate
