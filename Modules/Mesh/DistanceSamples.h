#pragma once

#include "Vector3.h"

#include <vector>

namespace palpate
{
/// Distances (mm, signed or not) of points of a surface from another one. Sums over the samples are
/// integrals over the surface's area, and `Largest` is over all of its triangles.
struct DistanceSamples
{
  std::vector<Vector3> Points; ///< first those of the surface's mesh, in its order
  std::vector<double> Values;
  std::vector<double> Weights; ///< parts of the area, not negative; they sum to 1
  double Largest = 0.0;        ///< without sign
  Vector3 Farthest = Vector3::Zero();
};

/// Distances (mm, without sign) over a surface's area.
struct DistanceSummary
{
  double Mean = 0.0;
  double Rms = 0.0;
  double Percentile95 = 0.0; ///< least distance not exceeded on 95 % of the area
  double Largest = 0.0;
};

DistanceSummary Summarise(const DistanceSamples& samples);

/// Of both directions together, each with half of the weight; symmetric.
DistanceSummary TwoSidedDistances(const DistanceSamples& there, const DistanceSamples& back);

/// The share of the area at which the distance without sign is at most `limit`.
double ShareWithin(const DistanceSamples& samples, double limit);

struct WeightedValue
{
  double Value;
  double Weight; ///< not negative
};

/// The least of the values such that no more than `above` of the weight exceeds it; 0 of none.
double WeightedQuantile(std::vector<WeightedValue> values, double above);
} // namespace palpate
