#include "RampIn.h"

#include <algorithm>

namespace palpate
{
double RampIn::Advance(double period) noexcept
{
  if (!this->IsFirst && period > 0.0)
  {
    this->Elapsed = std::min(this->Elapsed + period, std::max(this->Duration, 0.0));
  }
  this->IsFirst = false;
  return this->IsRamping() ? this->Elapsed / this->Duration : 1.0;
}
} // namespace palpate
