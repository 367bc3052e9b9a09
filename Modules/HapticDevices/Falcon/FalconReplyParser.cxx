#include "FalconReplyParser.h"

#include <algorithm>

namespace palpate
{
bool FalconReplyParser::Take(std::uint8_t byte, FalconReply& reply) noexcept
{
  this->Window[this->Count++] = byte;
  while (!MayBeginReply(this->Window.data(), this->Count))
  {
    std::copy(this->Window.begin() + 1,
              this->Window.begin() + static_cast<std::ptrdiff_t>(this->Count),
              this->Window.begin());
    --this->Count;
    ++this->Skipped;
  }
  if (this->Count < FalconPacketSize)
  {
    return false;
  }
  reply = DecodedReply(this->Window);
  this->Count = 0;
  return true;
}
} // namespace palpate
