#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// Outputs along one axis of a grid.
struct AxisNodes
{
  int Samples = 1;        ///< inputs, at 0, 1, ...
  int Count = 1;          ///< outputs
  double First = 0.0;     ///< output, in samples
  double Step = 1.0;      ///< between outputs, in samples
  double Deviation = 0.0; ///< standard deviation of the Gaussian, in steps
};

/// A linear operator along one axis of a grid: interpolation between samples at unit steps,
/// averaged with a Gaussian's weights. Beyond the samples the outermost one is repeated.
class AxisWeights
{
public:
  /// All meet the samples. Cubic is that by Catmull and Rom (Keys, "Cubic convolution interpolation
  /// for digital image processing", IEEE TASSP 29, 1981), quintic Lagrange's polynomial through the
  /// six samples around a place.
  enum class Interpolation
  {
    Linear,
    Cubic,
    Quintic
  };

  explicit AxisWeights(const AxisNodes& nodes, Interpolation between = Interpolation::Linear);

  /// Applies the operator along `axis` to an array of `size` (i fastest) and updates the size.
  std::vector<float> Apply(const std::vector<float>& values, std::array<int, 3>& size,
                           std::size_t axis) const;

private:
  struct Tap
  {
    int Sample;
    float Weight;
  };

  void AddOutput(const AxisNodes& nodes, int output, const std::vector<double>& gaussian,
                 Interpolation between);
  void AddTap(int sample, double weight);
  void ApplyToRow(const float* from, float* to) const;
  void ApplyToBlocks(const float* from, float* to, std::size_t stride) const;

  std::vector<Tap> Taps;
  std::vector<std::size_t> Starts{0}; // of each output's taps
};
} // namespace palpate
