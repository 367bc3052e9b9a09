#include "ErrorText.h"

#include "ExceptionMessage.h"

#include <algorithm>
#include <cstdio>
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

void SetError(palpate_error* error, const std::exception& problem) noexcept
{
  try
  {
    SetError(error, MessageOf(problem));
  }
  catch (const std::exception&)
  {
    SetError(error, "no memory"); // short enough to need none
  }
}

bool AreGiven(std::initializer_list<Argument> needed, palpate_error* error) noexcept
{
  for (const Argument& argument : needed)
  {
    const bool isMissing = argument.Array == nullptr && argument.Count > 0;
    if (!isMissing && argument.Count <= MostElements)
    {
      continue;
    }
    if (error != nullptr)
    {
      std::snprintf(error->text, sizeof error->text,
                    isMissing ? "the argument '%s' is NULL"
                              : "the argument '%s' has too many elements",
                    argument.Name);
    }
    return false;
  }
  return true;
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
