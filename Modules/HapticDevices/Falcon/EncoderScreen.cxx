#include "EncoderScreen.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace palpate
{
namespace
{
// A count moves the grip by 0.04 mm. In a millisecond, 12 of them off the line would be at least
// 500 m/s^2.
constexpr double Tolerance = 12.0;
// 2.5 m/s, which a hand cannot reach within 100 mm.
constexpr double LargestSpeed = 60.0; // counts/ms
constexpr double LongestLine = 10.0;  // ms for which a speed is extrapolated

double Milliseconds(std::int64_t duration) noexcept
{
  return std::max(1.0, 1e-6 * static_cast<double>(duration));
}

double Difference(std::int16_t from, std::int16_t to) noexcept
{
  return static_cast<std::int16_t>(to - from);
}
} // namespace

bool EncoderScreen::AreNear(const Reading& from, const Reading& to) noexcept
{
  const double largest = LargestSpeed * Milliseconds(to.Time - from.Time);
  bool areNear = from.IsThere;
  for (std::size_t leg = 0; leg < 3; ++leg)
  {
    areNear = areNear && std::abs(Difference(from.Counts[leg], to.Counts[leg])) <= largest;
  }
  return areNear;
}

bool EncoderScreen::GoesOn(const Reading& reading) const noexcept
{
  const double duration = Milliseconds(reading.Time - this->Last.Time);
  const double before = Milliseconds(this->Last.Time - this->Before.Time);
  const double ahead = std::min(duration, LongestLine) / before;
  bool goesOn = this->Last.IsThere;
  for (std::size_t leg = 0; leg < 3; ++leg)
  {
    const double last =
        this->Before.IsThere ? Difference(this->Before.Counts[leg], this->Last.Counts[leg]) : 0.0;
    const double motion = Difference(this->Last.Counts[leg], reading.Counts[leg]);
    goesOn = goesOn && std::abs(motion - ahead * last) <= Tolerance * duration;
  }
  return goesOn;
}

bool EncoderScreen::Believes(const FalconNumbers& counts, std::int64_t time) noexcept
{
  const Reading reading{counts, time, true};
  if (this->GoesOn(reading))
  {
    this->Before = this->Last;
  }
  else if (AreNear(this->Doubtful, reading))
  {
    this->Before = this->Doubtful;
  }
  else
  {
    this->Doubtful = reading;
    return false;
  }
  this->Last = reading;
  this->Doubtful = {};
  return true;
}
} // namespace palpate
