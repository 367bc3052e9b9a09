#include "GuideLaw.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Of k R: D (1 - D^2/R^2)^2 at D = R / sqrt(5).
const double LargestPart = 16.0 / (25.0 * std::sqrt(5.0));
} // namespace

GuideLaw::GuideLaw(const GuideSettings& settings, double steepest)
    : Reach(settings.Range),
      Spring(std::min(settings.Stiffness,
                      settings.LargestForce / (LargestPart * settings.Range * steepest)))
{
}

double GuideLaw::LargestForce() const noexcept
{
  return LargestPart * this->Spring * this->Reach;
}

double GuideLaw::Left(double squaredDistance) const noexcept
{
  const double left = 1.0 - squaredDistance / (this->Reach * this->Reach);
  return left > 0.0 ? left : 0.0; // false for what is not a number
}

double GuideLaw::PullAt(double squaredDistance) const noexcept
{
  const double left = this->Left(squaredDistance);
  return this->Spring * left * left;
}

double GuideLaw::PotentialAt(double squaredDistance) const noexcept
{
  const double left = this->Left(squaredDistance);
  return -this->Energy() * left * left * left;
}
} // namespace palpate
