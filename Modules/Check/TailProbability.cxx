#include "TailProbability.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double TailFrom = 0.8; // quantiles
constexpr double TailTo = 0.97;
} // namespace

TailProbability::TailProbability(std::vector<double> values, const CheckRule& rule)
    : Values(std::move(values)), On(rule.Scale), LeastTail(rule.LeastTail)
{
  std::sort(this->Values.begin(), this->Values.end());
}

double TailProbability::Scaled(double value) const
{
  switch (this->On)
  {
  case TailScale::Logarithm:
    return std::log(std::max(value, 0.0) + 0.002);
  case TailScale::Bounded:
    return -std::log(1.02 - std::clamp(value, 0.0, 1.0));
  case TailScale::Square:
    return 0.5 * value * std::abs(value);
  }
  return value;
}

double TailProbability::Of(double value, double without) const
{
  const auto found = std::lower_bound(this->Values.begin(), this->Values.end(), without);
  const bool isWithout = !std::isnan(without) && found != this->Values.end() && *found == without;
  const std::size_t left =
      isWithout ? static_cast<std::size_t>(found - this->Values.begin()) : this->Values.size();
  const std::size_t count = this->Values.size() - (isWithout ? 1 : 0);
  if (count == 0)
  {
    return 1.0;
  }
  const auto at = [&](std::size_t n) { return this->Values[n < left ? n : n + 1]; };
  const auto quantile = [&](double share)
  { return at(static_cast<std::size_t>(share * static_cast<double>(count - 1))); };
  const double last = this->On == TailScale::Bounded ? quantile(TailTo) : at(count - 1);
  std::size_t below = 0;
  while (below < count && at(below) < std::min(value, last)) // of some hundred values
  {
    ++below;
  }
  const double rank = static_cast<double>(1 + count - below) / static_cast<double>(count + 1);
  if (value <= last)
  {
    return rank;
  }
  const double first = this->Scaled(quantile(TailFrom));
  double excess = 0.0;
  for (std::size_t n = static_cast<std::size_t>(TailFrom * static_cast<double>(count - 1));
       n < count; ++n)
  {
    excess += this->Scaled(at(n)) - first;
  }
  const double beyond = (1.0 - TailFrom) * static_cast<double>(count);
  const double tail = std::max(excess / beyond, this->LeastTail);
  const double share = this->On == TailScale::Bounded
                           ? std::min(rank, 1.0 - TailTo + 1.0 / static_cast<double>(count + 1))
                           : 1.0 / static_cast<double>(count + 1);
  return share * std::exp((this->Scaled(last) - this->Scaled(value)) / tail);
}
} // namespace palpate
