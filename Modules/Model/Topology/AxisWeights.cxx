#include "AxisWeights.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double WeightReach = 3.0; // in standard deviations

// The weights of a Gaussian from its centre to one side; with the other side they sum to one.
std::vector<double> HalfGaussian(double deviation)
{
  std::vector<double> weights{1.0};
  double sum = 1.0;
  for (int n = 1; n <= WeightReach * deviation; ++n)
  {
    weights.push_back(std::exp(-0.5 * n * n / (deviation * deviation)));
    sum += 2.0 * weights.back();
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

// Of the samples at -2, -1, ..., 3, for a place `t` in [0, 1].
using Weights = std::array<double, 6>;

Weights LinearWeights(double t)
{
  return {0.0, 0.0, 1.0 - t, t, 0.0, 0.0};
}
Weights CubicWeights(double t)
{
  const double s = 1.0 - t;
  return {0.0,
          -0.5 * t * s * s,
          1.0 + t * t * (1.5 * t - 2.5),
          1.0 + s * s * (1.5 * s - 2.5),
          -0.5 * s * t * t,
          0.0};
}
Weights QuinticWeights(double t)
{
  Weights weights{};
  for (int sample = -2; sample <= 3; ++sample)
  {
    double weight = 1.0;
    for (int other = -2; other <= 3; ++other)
    {
      weight *= other == sample ? 1.0 : (t - other) / (sample - other);
    }
    weights[static_cast<std::size_t>(sample + 2)] = weight;
  }
  return weights;
}

Weights WeightsOf(AxisWeights::Interpolation interpolation, double t)
{
  switch (interpolation)
  {
  case AxisWeights::Interpolation::Cubic:
    return CubicWeights(t);
  case AxisWeights::Interpolation::Quintic:
    return QuinticWeights(t);
  default:
    return LinearWeights(t);
  }
}
} // namespace

AxisWeights::AxisWeights(const AxisNodes& nodes, Interpolation between)
{
  const std::vector<double> gaussian = HalfGaussian(nodes.Deviation);
  for (int n = 0; n < nodes.Count; ++n)
  {
    this->AddOutput(nodes, n, gaussian, between);
  }
}

void AxisWeights::AddTap(int sample, double weight)
{
  if (this->Taps.size() > this->Starts.back() && this->Taps.back().Sample == sample)
  {
    this->Taps.back().Weight += static_cast<float>(weight);
  }
  else if (weight != 0.0)
  {
    this->Taps.push_back({sample, static_cast<float>(weight)});
  }
}

void AxisWeights::AddOutput(const AxisNodes& nodes, int output, const std::vector<double>& gaussian,
                            Interpolation between)
{
  const int last = nodes.Samples - 1;
  const int reach = static_cast<int>(gaussian.size()) - 1;
  for (int n = -reach; n <= reach; ++n)
  {
    const double at = std::clamp(nodes.First + output * nodes.Step + n * nodes.Step, 0.0,
                                 static_cast<double>(last));
    const int low = std::min(static_cast<int>(at), std::max(last - 1, 0));
    const double weight = gaussian[static_cast<std::size_t>(std::abs(n))];
    const Weights around = WeightsOf(between, at - low);
    for (int sample = -2; sample <= 3; ++sample)
    {
      this->AddTap(std::clamp(low + sample, 0, last),
                   weight * around[static_cast<std::size_t>(sample + 2)]);
    }
  }
  this->Starts.push_back(this->Taps.size());
}

void AxisWeights::ApplyToRow(const float* from, float* to) const
{
  for (std::size_t n = 0; n + 1 < this->Starts.size(); ++n)
  {
    float sum = 0.0f;
    for (std::size_t tap = this->Starts[n]; tap < this->Starts[n + 1]; ++tap)
    {
      sum += this->Taps[tap].Weight * from[this->Taps[tap].Sample];
    }
    to[n] = sum;
  }
}

// Weighted sums of blocks of `stride` contiguous values.
void AxisWeights::ApplyToBlocks(const float* from, float* to, std::size_t stride) const
{
  for (std::size_t n = 0; n + 1 < this->Starts.size(); ++n, to += stride)
  {
    std::fill_n(to, stride, 0.0f);
    for (std::size_t tap = this->Starts[n]; tap < this->Starts[n + 1]; ++tap)
    {
      const float weight = this->Taps[tap].Weight;
      const float* block = from + static_cast<std::size_t>(this->Taps[tap].Sample) * stride;
      for (std::size_t at = 0; at < stride; ++at)
      {
        to[at] += weight * block[at];
      }
    }
  }
}

std::vector<float> AxisWeights::Apply(const std::vector<float>& values, std::array<int, 3>& size,
                                      std::size_t axis) const
{
  std::size_t stride = 1;
  for (std::size_t before = 0; before < axis; ++before)
  {
    stride *= static_cast<std::size_t>(size[before]);
  }
  const std::size_t inBlock = stride * static_cast<std::size_t>(size[axis]);
  const std::size_t outBlock = stride * (this->Starts.size() - 1);
  const std::size_t blocks = values.size() / inBlock;
  std::vector<float> result(blocks * outBlock);
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const float* from = &values[block * inBlock];
    float* to = &result[block * outBlock];
    stride == 1 ? this->ApplyToRow(from, to) : this->ApplyToBlocks(from, to, stride);
  }
  size[axis] = static_cast<int>(this->Starts.size() - 1);
  return result;
}
} // namespace palpate
