#include "ErrorText.h"

#include <algorithm>
#include <cstring>

namespace palpate
{
void SetError(palpate_error* error, const std::string& message) noexcept
{
  if (error == nullptr)
  {
    return;
  }
  std::size_t length = std::min(message.size(), sizeof(error->text) - 1);
  // Not within a character of UTF-8.
  while (length > 0 && length < message.size() &&
         (static_cast<unsigned char>(message[length]) & 0xC0U) == 0x80U)
  {
    --length;
  }
  std::memcpy(error->text, message.data(), length);
  error->text[length] = '\0';
}

int Told(const Status& status, palpate_error* error) noexcept
{
  if (!status.IsOk())
  {
    SetError(error, status.Message());
  }
  return status.IsOk() ? 1 : 0;
}
} // namespace palpate
