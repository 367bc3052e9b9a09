#include "IgtlProgress.h"

namespace palpate
{
void IgtlProgress::Sent(std::uint64_t count, std::int64_t now) noexcept
{
  this->Total += count;
  if (!this->HasMark)
  {
    this->HasMark = true;
    this->Mark = this->Total;
    this->MarkTime = now;
  }
}

void IgtlProgress::Update(std::uint64_t unconfirmed, std::int64_t now) noexcept
{
  if (!this->HasMark)
  {
    return;
  }
  const bool isConfirmed = this->Mark + unconfirmed <= this->Total;
  const bool isLate = now - this->MarkTime > this->Longest;
  if (isConfirmed || isLate)
  {
    this->Behind = isLate;
  }
  this->HasMark = !isConfirmed;
}
} // namespace palpate
