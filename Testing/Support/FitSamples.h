#pragma once

#include "FitRun.h"
#include "IcosahedronDirections.h"
#include "RadialModelFit.h"
#include "RandomShapes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace palpate::test
{
/// Noise-free samples of a model along an icosahedron's directions, weighted by solid angle.
inline RadialSamples SamplesOf(const RadialModel& model, int frequency)
{
  const IcosahedronDirections sphere(frequency);
  RadialSamples samples{sphere.Directions(), {}, sphere.SolidAngles()};
  for (const Vector3& u : samples.Directions)
  {
    samples.Radii.push_back(model.Radius(u));
  }
  return samples;
}

inline void AddNoise(Random& random, double deviation, RadialSamples& samples)
{
  std::normal_distribution<double> noise(0.0, deviation);
  for (double& radius : samples.Radii)
  {
    radius += noise(random);
  }
}

/// Removes the directions within `angle` rad of the +z axis.
inline RadialSamples WithoutCap(const RadialSamples& samples, double angle)
{
  RadialSamples kept;
  for (std::size_t i = 0; i < samples.Radii.size(); ++i)
  {
    if (samples.Directions[i].z() <= std::cos(angle))
    {
      kept.Directions.push_back(samples.Directions[i]);
      kept.Radii.push_back(samples.Radii[i]);
      kept.Weights.push_back(samples.Weights[i]);
    }
  }
  return kept;
}

/// Sets the weight of every `step`-th sample to zero and its radius to an absurd value; returns the
/// others.
inline RadialSamples SilenceEvery(std::size_t step, RadialSamples& samples)
{
  RadialSamples kept;
  for (std::size_t i = 0; i < samples.Radii.size(); ++i)
  {
    if (i % step == 0)
    {
      samples.Weights[i] = 0.0;
      samples.Radii[i] = 1e6;
      continue;
    }
    kept.Directions.push_back(samples.Directions[i]);
    kept.Radii.push_back(samples.Radii[i]);
    kept.Weights.push_back(samples.Weights[i]);
  }
  return kept;
}

/// A fit by one solver only.
template <typename Solver>
RadialModelFitResult FitBy(const RadialSamples& samples, const RadialModelFitOptions& options)
{
  Solver solver(options.Degree);
  RadialModelFitResult result;
  const Status status = FitRun(samples, options, solver).Run(result);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return result;
}

/// Norm of the difference of two coefficient vectors.
inline double Distance(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k)
  {
    const double difference = (k < a.size() ? a[k] : 0.0) - (k < b.size() ? b[k] : 0.0);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

inline double Norm(const std::vector<double>& a)
{
  return Distance(a, {});
}
} // namespace palpate::test
