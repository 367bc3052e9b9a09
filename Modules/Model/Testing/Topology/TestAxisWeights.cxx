#include "AxisWeights.h"

#include <gtest/gtest.h>

namespace palpate::axis_weights_test
{
namespace
{
using Interpolation = AxisWeights::Interpolation;

// Values of a parabola at 0, 1, ..., and at places between them.
constexpr int Samples = 9;
constexpr double Step = 0.125;
double Parabola(double x)
{
  return 3.0 + x * (0.5 - 0.25 * x);
}

std::vector<float> Between(Interpolation interpolation, std::array<int, 3>& size)
{
  std::vector<float> values(Samples);
  for (int n = 0; n < Samples; ++n)
  {
    values[static_cast<std::size_t>(n)] = static_cast<float>(Parabola(n));
  }
  size = {Samples, 1, 1};
  const AxisWeights weights({Samples, 65, 0.0, Step, 0.0}, interpolation);
  return weights.Apply(values, size, 0);
}

TEST(AxisWeights, AllMeetTheSamples)
{
  for (const Interpolation interpolation :
       {Interpolation::Linear, Interpolation::Cubic, Interpolation::Quintic})
  {
    std::array<int, 3> size{};
    const std::vector<float> values = Between(interpolation, size);
    ASSERT_EQ(size[0], 65);
    for (int n = 0; n < Samples; ++n)
    {
      EXPECT_FLOAT_EQ(values[static_cast<std::size_t>(8 * n)], static_cast<float>(Parabola(n)));
    }
  }
}

TEST(AxisWeights, CubicKeepsParabolas)
{
  std::array<int, 3> size{};
  const std::vector<float> values = Between(Interpolation::Cubic, size);
  // Beyond the outermost samples nothing is known.
  for (int n = 8; n <= 56; ++n)
  {
    EXPECT_NEAR(values[static_cast<std::size_t>(n)], Parabola(n * Step), 1e-6) << n; // floats
  }
}

TEST(AxisWeights, QuinticIsThePolynomialThroughSixSamples)
{
  const auto polynomial = [](double x)
  {
    const double t = x - 4.0;
    return 2.0 + t * (1.0 - t * (0.5 + t * (0.25 - t * (0.125 - 0.03125 * t))));
  };
  std::vector<float> values(Samples);
  for (int n = 0; n < Samples; ++n)
  {
    values[static_cast<std::size_t>(n)] = static_cast<float>(polynomial(n));
  }
  std::array<int, 3> size{Samples, 1, 1};
  const AxisWeights weights({Samples, 33, 2.0, Step, 0.0}, Interpolation::Quintic);
  values = weights.Apply(values, size, 0);
  for (int n = 0; n < size[0]; ++n)
  {
    const double x = 2.0 + n * Step;
    EXPECT_NEAR(values[static_cast<std::size_t>(n)], polynomial(x), 1e-5) << x; // floats up to 14
  }
}

TEST(AxisWeights, LinearIsTheChord)
{
  std::array<int, 3> size{};
  const std::vector<float> values = Between(Interpolation::Linear, size);
  EXPECT_FLOAT_EQ(values[12], static_cast<float>(0.5 * (Parabola(1.0) + Parabola(2.0))));
}

TEST(AxisWeights, OneSampleIsRepeated)
{
  for (const Interpolation interpolation :
       {Interpolation::Linear, Interpolation::Cubic, Interpolation::Quintic})
  {
    std::array<int, 3> size{1, 1, 1};
    const AxisWeights weights({1, 4, -1.0, 0.5, 0.5}, interpolation);
    for (const float value : weights.Apply({2.5F}, size, 0))
    {
      EXPECT_FLOAT_EQ(value, 2.5F);
    }
  }
}
} // namespace
} // namespace palpate::axis_weights_test
