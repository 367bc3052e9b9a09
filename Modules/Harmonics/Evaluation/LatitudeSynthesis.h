#pragma once

#include "RadialModel.h"
#include "SphericalHarmonicBasis.h"
#include "Vector3.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Evaluates a model along circles of latitude, at equal steps of longitude. All directions of a
/// circle share the harmonics at longitude 0, so the sums over degrees are computed once per order
/// and circle, and each point takes only the sum over orders: some L operations instead of L^2 for
/// a single direction. For quadratures and grids.
class LatitudeSynthesis
{
public:
  /// `longitudeCount` >= 1. Keeps a copy of the model's coefficients.
  LatitudeSynthesis(const RadialModel& model, int longitudeCount);

  /// (s cos a, s sin a, z) with s = sqrt(1 - z^2) and a = 2 pi j / longitudeCount.
  Vector3 Direction(double z, std::size_t j) const noexcept;
  /// Samples at Direction(z, j) for every j; valid until the next call. -1 < z < 1: gradients at
  /// the poles are NaN.
  const std::vector<RadialModel::Sample>& Evaluate(double z);

private:
  // Factors of the cosine and the sine of an order's longitude, on one circle.
  struct OrderSums
  {
    double Cosine = 0.0; // of the radius
    double Sine = 0.0;
    double CosineSlope = 0.0; // of its derivative by the angle from +z
    double SineSlope = 0.0;
  };
  void SumDegrees(double z, double s);
  void AddOrder(int order, const OrderSums& sums) noexcept;
  void Turn() noexcept;
  void Store(double z, double s) noexcept;

  SphericalHarmonicBasis Basis;
  std::vector<double> Coefficients;
  std::vector<double> Ladder; // sqrt((l - m) (l + m + 1)), m = 0..l, degree by degree
  // On the current circle:
  std::vector<double> Harmonics; // at longitude 0
  std::vector<OrderSums> Sums;
  // By longitude: the constant cos a and sin a, the running cos m a and sin m a, and the results.
  std::vector<double> StepCosine;
  std::vector<double> StepSine;
  std::vector<double> Cosine;
  std::vector<double> Sine;
  std::vector<double> Radius;
  std::vector<double> SouthSlope;
  std::vector<double> EastSlope; // times s
  std::vector<RadialModel::Sample> Samples;
};
} // namespace palpate
