#include "TickBudget.h"

#include <algorithm>

namespace palpate
{
namespace
{
// Parts of the period, in percent.
constexpr std::int64_t CrowdedPercent = 70;
constexpr std::int64_t BusyPercent = 35;
// ns
constexpr std::int64_t SoonAgain = 50'000'000;
constexpr std::int64_t LateAgain = 1'000'000'000;
} // namespace

bool TickBudget::Twice::Take(std::int64_t now, bool isLong, std::int64_t within) noexcept
{
  const bool isAgain = isLong && this->HasLast && now - this->Last <= within;
  if (isLong)
  {
    this->Last = now;
    this->HasLast = !isAgain;
  }
  return isAgain;
}

void TickBudget::Take(std::int64_t started, std::int64_t spent, int most) noexcept
{
  this->Current = std::min(this->Current, most);
  const auto takes = [&](std::int64_t percent) { return 100 * spent > percent * this->Period; };
  const bool isCrowded = this->Crowded.Take(started, takes(CrowdedPercent), SoonAgain);
  const bool isLate = this->Late.Take(started, takes(100), LateAgain);
  if (this->Busy.Take(started, takes(BusyPercent), SoonAgain))
  {
    this->RoomSince = started;
  }
  if ((isCrowded || isLate) && this->Current < most)
  {
    this->Raise(started);
  }
  else if (this->Current > 0 && started - this->RoomSince >= this->Patience)
  {
    this->Lower(started);
  }
}

void TickBudget::Raise(std::int64_t now) noexcept
{
  const bool isTooSoon = this->WasLowered && now - this->Lowered < this->Patience;
  this->Patience = isTooSoon ? std::min(2 * this->Patience, MostPatience) : LeastPatience;
  this->WasLowered = false;
  this->RoomSince = now;
  this->Crowded = {};
  this->Late = {};
  ++this->Current;
}

void TickBudget::Lower(std::int64_t now) noexcept
{
  this->Lowered = now;
  this->WasLowered = true;
  this->RoomSince = now;
  --this->Current;
}
} // namespace palpate
