#include "JpegLsBits.h"

namespace palpate
{
void JpegLsBits::Fill(int count)
{
  while (this->Available < count && !this->Ended)
  {
    if (this->Next == this->End || (this->IsAfterFull && *this->Next >= 0x80))
    {
      this->Ended = true;
      return;
    }
    const int bits = this->IsAfterFull ? 7 : 8;
    const std::uint64_t byte = *this->Next++;
    this->IsAfterFull = byte == 0xFF;
    this->Cache |= byte << (64 - bits - this->Available);
    this->Available += bits;
  }
}

bool JpegLsBits::IsAtMarker() const
{
  // After a last byte of 0xFF there may be one of seven padding bits.
  const bool isPadded = this->IsAfterFull && this->Next != this->End && *this->Next < 0x80;
  const std::uint8_t* marker = this->Next + (isPadded ? 1 : 0);
  return this->Available < 8 && this->End - marker >= 2 && marker[0] == 0xFF && marker[1] >= 0x80;
}
} // namespace palpate
