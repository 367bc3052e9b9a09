#include "HandTremor.h"

#include "Units.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr double PeakFrequency = 9.0; // Hz, the middle of 6 to 12 (Riviere; Sutton and Sykes)
constexpr double Bandwidth = 3.0;     // Hz, half width at half power
} // namespace

HandTremor::HandTremor(double rate)
{
  const double radius = std::exp(-2.0 * Pi * Bandwidth / rate);
  const double angle = 2.0 * Pi * PeakFrequency / rate;
  const double squared = radius * radius;
  this->First = 2.0 * radius * std::cos(angle);
  this->Second = -squared;
  // The process's variance over that of its noise.
  const double variance =
      (1.0 + squared) /
      ((1.0 - squared) * (1.0 + squared * squared - 2.0 * squared * std::cos(2.0 * angle)));
  this->Gain = 1.0 / std::sqrt(variance);
}

Vector3 HandTremor::Next(std::mt19937_64& random)
{
  const double x = this->Normal(random);
  const double y = this->Normal(random);
  const double z = this->Normal(random);
  const Vector3 next =
      this->First * this->Last + this->Second * this->Before + this->Gain * Vector3(x, y, z);
  this->Before = this->Last;
  this->Last = next;
  return next;
}
} // namespace palpate
