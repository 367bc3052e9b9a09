#include "DegreeBracket.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Up to here fits cost little, and residuals of smooth bodies fall by steps: no line is trusted.
constexpr int UsualDegree = 12;
// Of AAL's structures between degrees 12 and 33.
constexpr double UsualDecay = 0.06;
// The work grows with the fourth power of the degree: no longer steps, by ratio.
constexpr double LongestStep = 1.5;
// Degrees by which the line may cross below the degree that is one too low.
constexpr double Slack = 0.5;
} // namespace

DegreeBracket::DegreeBracket(double tolerance, int least, int highest) noexcept
    : Tolerance(tolerance), Least(least), Highest(std::max(least, highest)), Decay(UsualDecay)
{
}

double DegreeBracket::Crossing() const noexcept
{
  return this->Missed->Degree + this->Missed->Excess / this->Decay;
}

std::optional<int> DegreeBracket::Next() const noexcept
{
  if (!this->Missed && !this->Met)
  {
    return std::clamp(UsualDegree, this->Below() + 1, this->Highest);
  }
  if (!this->Met)
  {
    return this->Below() < this->Highest ? std::optional<int>(this->NextUpwards()) : std::nullopt;
  }
  const int below = this->Met->Degree - 1;
  if (this->Below() >= below)
  {
    return {};
  }
  if (below < UsualDegree)
  {
    return (this->Below() + this->Met->Degree) / 2;
  }
  const double crossing = this->Crossing();
  return crossing > below - Slack ? std::nullopt
                                  : std::optional<int>(std::max(
                                        static_cast<int>(std::ceil(crossing)), this->Below() + 1));
}

// A degree that just misses costs a fit more; one that is a degree too high hardly anything.
int DegreeBracket::NextUpwards() const noexcept
{
  const int longest = std::min(static_cast<int>(LongestStep * (this->Below() + 1)), this->Highest);
  const double wanted = std::min<double>(std::ceil(this->Crossing() + Slack), longest);
  return std::max(static_cast<int>(wanted), this->Below() + 1);
}

bool DegreeBracket::Add(int degree, double rms) noexcept
{
  const double excess =
      std::isfinite(rms) ? std::log(std::max(rms, 1e-300) / this->Tolerance) : 1.0;
  const bool misses = excess > 0.0;
  std::optional<Tried>& end = misses ? this->Missed : this->Met;
  const std::optional<Tried>& other = misses ? this->Met : this->Missed;
  const std::optional<Tried> from = other ? other : end;
  end = Tried{degree, excess};
  const double decay = from ? (from->Excess - excess) / (degree - from->Degree) : UsualDecay;
  this->Decay = decay > 0.0 ? decay : UsualDecay;
  return !misses || !this->Met;
}
} // namespace palpate
