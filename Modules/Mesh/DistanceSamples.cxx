#include "DistanceSamples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace palpate
{
namespace
{
constexpr double BeyondPercentile95 = 0.05;

void Append(const DistanceSamples& samples, double share, std::vector<WeightedValue>& values)
{
  for (std::size_t i = 0; i < samples.Values.size(); ++i)
  {
    values.push_back({std::abs(samples.Values[i]), share * samples.Weights[i]});
  }
}

// Without the percentile.
DistanceSummary Moments(const DistanceSamples& samples)
{
  DistanceSummary summary;
  for (std::size_t i = 0; i < samples.Values.size(); ++i)
  {
    const double value = samples.Values[i];
    summary.Mean += samples.Weights[i] * std::abs(value);
    summary.Rms += samples.Weights[i] * value * value;
  }
  summary.Rms = std::sqrt(summary.Rms);
  summary.Largest = samples.Largest;
  return summary;
}
} // namespace

// By halves: what is sorted out is not sorted.
double WeightedQuantile(std::vector<WeightedValue> values, double above)
{
  auto begin = values.begin();
  auto end = values.end();
  while (end - begin > 1)
  {
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end,
                     [](const WeightedValue& a, const WeightedValue& b)
                     { return a.Value < b.Value; });
    const double upper = std::accumulate(
        middle, end, 0.0, [](double sum, const WeightedValue& one) { return sum + one.Weight; });
    if (upper > above)
    {
      begin = middle;
    }
    else
    {
      above -= upper;
      end = middle;
    }
  }
  return begin != end ? begin->Value : 0.0;
}

DistanceSummary Summarise(const DistanceSamples& samples)
{
  DistanceSummary summary = Moments(samples);
  std::vector<WeightedValue> values;
  values.reserve(samples.Values.size());
  Append(samples, 1.0, values);
  summary.Percentile95 = WeightedQuantile(std::move(values), BeyondPercentile95);
  return summary;
}

DistanceSummary TwoSidedDistances(const DistanceSamples& there, const DistanceSamples& back)
{
  const DistanceSummary one = Moments(there);
  const DistanceSummary other = Moments(back);
  std::vector<WeightedValue> values;
  values.reserve(there.Values.size() + back.Values.size());
  Append(there, 0.5, values);
  Append(back, 0.5, values);
  return {0.5 * (one.Mean + other.Mean),
          std::sqrt(0.5 * (one.Rms * one.Rms + other.Rms * other.Rms)),
          WeightedQuantile(std::move(values), BeyondPercentile95),
          std::max(one.Largest, other.Largest)};
}

// Exactly 0 or 1 where none or all are within.
double ShareWithin(const DistanceSamples& samples, double limit)
{
  double within = 0.0;
  double beyond = 0.0;
  for (std::size_t i = 0; i < samples.Values.size(); ++i)
  {
    (std::abs(samples.Values[i]) <= limit ? within : beyond) += samples.Weights[i];
  }
  return within > 0.0 ? within / (within + beyond) : 0.0;
}
} // namespace palpate
