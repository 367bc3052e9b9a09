#pragma once

#include "SphericalHarmonicModel.h"
#include "SphericalHarmonicRecurrence.h"
#include "Vector3.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Evaluates a model along circles of latitude, at equal steps of longitude. All directions of a
/// circle share z, so the sums over degrees are made once for each order and circle and only the
/// sum over orders is left for a point: some L operations a point where a single direction takes
/// L^2. For quadratures and grids.
class LatitudeSynthesis
{
public:
  /// `longitudeCount` >= 1. Keeps a copy of the model's coefficients.
  LatitudeSynthesis(const SphericalHarmonicModel& model, int longitudeCount);

  /// (s cos a, s sin a, z) with s = sqrt(1 - z^2) and a = 2 pi j / longitudeCount.
  Vector3 Direction(double z, std::size_t j) const noexcept;
  /// Samples at Direction(z, j) for every j; valid until the next call. `z` is in [-1, 1].
  const std::vector<SphericalHarmonicModel::Sample>& Evaluate(double z);

private:
  // The terms of one order on a circle: with powers of s, but without the longitude.
  struct OrderSums
  {
    double Cosine; // times cos m a: the radius
    double Sine;
    double CosineSlope; // the same of the slope in z
    double SineSlope;
    double LowerCosine; // times cos (m - 1) a: the slopes in x and y
    double LowerSine;
  };
  OrderSums SumDegrees(int order, double z, double power, double lowerPower) const noexcept;
  void AddOrder(const OrderSums& sums) noexcept;
  void Turn() noexcept;
  void Store(double z) noexcept;

  SphericalHarmonicRecurrence Recurrence;
  std::vector<double> Coefficients;
  // By longitude. First the constant cos a and sin a, then the running cos m a and cos (m - 1) a
  // ...
  std::vector<double> StepCosine;
  std::vector<double> StepSine;
  std::vector<double> Cosine;
  std::vector<double> Sine;
  std::vector<double> LowerCosine;
  std::vector<double> LowerSine;
  // ... and the sums.
  std::vector<double> Radius;
  std::vector<double> SlopeX;
  std::vector<double> SlopeY;
  std::vector<double> SlopeZ;
  std::vector<SphericalHarmonicModel::Sample> Samples;
};
} // namespace palpate
