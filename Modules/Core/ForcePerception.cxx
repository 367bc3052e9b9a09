#include "ForcePerception.h"

#include <cmath>

namespace palpate
{
double ForcePerception::JustNoticeable(double force)
{
  const double size = std::abs(force);
  // Written so that NaN is not hidden by the floor.
  return WeberFraction * (size < SmallestWeberForce ? SmallestWeberForce : size);
}

double ForcePerception::Contrast(double force, double reference)
{
  return (force - reference) / JustNoticeable(reference);
}
} // namespace palpate
