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

// Of the samples at -1, 0, 1, 2, for a place `t` in [0, 1].
std::array<double, 4> LinearWeights(double t)
{
  return {0.0, 1.0 - t, t, 0.0};
}
std::array<double, 4> CubicWeights(double t)
{
  const double s = 1.0 - t;
  return {-0.5 * t * s * s, 1.0 + t * t * (1.5 * t - 2.5), 1.0 + s * s * (1.5 * s - 2.5),
          -0.5 * s * t * t};
}
} // namespace

AxisWeights::AxisWeights(int samples, int count, double first, double step, double deviation,
                         Interpolation between)
{
  const std::vector<double> gaussian = HalfGaussian(deviation);
  for (int n = 0; n < count; ++n)
  {
    this->AddOutput(samples, first + n * step, step, gaussian, between);
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

void AxisWeights::AddOutput(int samples, double position, double step,
                            const std::vector<double>& gaussian, Interpolation between)
{
  const int reach = static_cast<int>(gaussian.size()) - 1;
  for (int n = -reach; n <= reach; ++n)
  {
    const double at = std::clamp(position + n * step, 0.0, samples - 1.0);
    const int low = std::min(static_cast<int>(at), std::max(samples - 2, 0));
    const double weight = gaussian[static_cast<std::size_t>(std::abs(n))];
    const std::array<double, 4> around =
        between == Interpolation::Cubic ? CubicWeights(at - low) : LinearWeights(at - low);
    for (int sample = 0; sample < 4; ++sample)
    {
      this->AddTap(std::clamp(low - 1 + sample, 0, samples - 1),
                   weight * around[static_cast<std::size_t>(sample)]);
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
