#include "ContentDigest.h"

#include <array>
#include <cstdio>

namespace palpate
{
void ContentDigest::AddBytes(std::string_view bytes)
{
  for (const char byte : bytes)
  {
    this->Hash = (this->Hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  }
}

void ContentDigest::Add(std::string_view piece)
{
  // The length first, so that different lists give different bytes.
  this->AddBytes(std::to_string(piece.size()) + ":");
  this->AddBytes(piece);
}

std::string ContentDigest::Text() const
{
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx",
                static_cast<unsigned long long>(this->Hash));
  return digits.data();
}
} // namespace palpate
