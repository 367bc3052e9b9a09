#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// A linear operator along one axis of a grid: interpolation between samples at unit steps,
/// averaged with a Gaussian's weights. Beyond the samples the outermost one is repeated.
class AxisWeights
{
public:
  /// Cubic is that by Catmull and Rom (Keys, "Cubic convolution interpolation for digital image
  /// processing", IEEE TASSP 29, 1981), which meets the samples.
  enum class Interpolation
  {
    Linear,
    Cubic
  };

  /// `count` outputs at `first` + n * `step` (in samples) from `samples` inputs; the Gaussian's
  /// standard deviation is in output steps.
  AxisWeights(int samples, int count, double first, double step, double deviation,
              Interpolation between = Interpolation::Linear);

  /// Applies the operator along `axis` to an array of `size` (i fastest) and updates the size.
  std::vector<float> Apply(const std::vector<float>& values, std::array<int, 3>& size,
                           std::size_t axis) const;

private:
  struct Tap
  {
    int Sample;
    float Weight;
  };

  void AddOutput(int samples, double position, double step, const std::vector<double>& gaussian,
                 Interpolation between);
  void AddTap(int sample, double weight);
  void ApplyToRow(const float* from, float* to) const;
  void ApplyToBlocks(const float* from, float* to, std::size_t stride) const;

  std::vector<Tap> Taps;
  std::vector<std::size_t> Starts{0}; // of each output's taps
};
} // namespace palpate
