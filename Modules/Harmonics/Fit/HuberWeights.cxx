#include "HuberWeights.h"

#include "Median.h"
#include "RadialSamples.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate
{
HuberWeights::HuberWeights(const std::vector<double>& weights)
    : Values(weights.size(), 1.0), Count(static_cast<double>(CountWeighted(weights)))
{
  const double mean =
      std::accumulate(weights.begin(), weights.end(), 0.0) / std::max(1.0, this->Count);
  for (const double weight : weights)
  {
    this->Roots.push_back(std::sqrt(weight / mean));
  }
}

void HuberWeights::Rescale(const std::vector<double>& residuals, double fitted, double smallest)
{
  // Median of |x| over the standard deviation of a normal variable x.
  constexpr double MedianOfNormal = 0.6744897501960817;
  this->Work.clear();
  for (std::size_t i = 0; i < residuals.size(); ++i)
  {
    if (this->Roots[i] > 0.0)
    {
      this->Work.push_back(std::abs(this->Standardised(residuals[i], i)));
    }
  }
  const double free = std::max(1.0, this->Count - fitted);
  this->Deviation =
      std::max(smallest, UpperMedian(this->Work) / MedianOfNormal * std::sqrt(this->Count / free));
}

void HuberWeights::Update(const std::vector<double>& residuals)
{
  const double limit = Tuning * this->Deviation;
  for (std::size_t i = 0; i < residuals.size(); ++i)
  {
    const double size = std::abs(this->Standardised(residuals[i], i));
    this->Values[i] = size <= limit ? 1.0 : limit / size;
  }
}

std::size_t HuberWeights::DownWeighted() const
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    count += this->Roots[i] > 0.0 && this->Values[i] < 1.0 ? 1 : 0;
  }
  return count;
}

double HuberWeights::Variance(const std::vector<double>& residuals, double fitted) const
{
  const double limit = Tuning * this->Deviation;
  double squares = 0.0;
  for (std::size_t i = 0; i < residuals.size(); ++i)
  {
    const double clipped = std::min(limit, std::abs(this->Standardised(residuals[i], i)));
    squares += clipped * clipped;
  }
  const double inside = 1.0 - static_cast<double>(this->DownWeighted()) / this->Count;
  const double correction = 1.0 + fitted / this->Count * (1.0 - inside) / inside;
  const double free = std::max(1.0, this->Count - fitted);
  return correction * correction * squares / free / (inside * inside);
}
} // namespace palpate
