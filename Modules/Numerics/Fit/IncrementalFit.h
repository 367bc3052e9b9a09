#pragma once

#include "MomentSolver.h"
#include "PackedTriangle.h"
#include "RadialSamples.h"
#include "SphericalHarmonicBasis.h"
#include "Status.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// A least-squares fit that follows its samples: one is added, taken away, or gets another radius,
/// and the coefficients are those of a fit from the start. Keeps the inverse of the normal
/// equations' matrix and changes it by the formula of Sherman and Morrison (Ann. Math. Statist. 21,
/// 1950): with g = P y for the harmonics y of a sample of weight w,
///   P := P -+ w / (1 +- w y.g) g g^T,   c := c +- w / (1 +- w y.g) (r - y.c) g.
/// The inverse is kept rather than a Cholesky factor because both products run in lanes without a
/// chain of rotations, and a new radius needs one product only. Rounding adds up slowly, by some
/// epsilon times the squared condition an update; Restart starts again from the samples at hand.
///
/// Changes are made in place: no allocation, no lock, nothing thrown, some microseconds at
/// degree 12.
class IncrementalFit
{
public:
  /// What became of a change. Other than Made, nothing has changed.
  enum class [[nodiscard]] Change{
      Made,
      NotFinite, ///< a number is not finite, beyond 1e100, the weight not positive, or u no unit
                 ///< vector
      Full,      ///< the capacity is used up
      Unknown,   ///< no sample has this number
      Singular   ///< what is left would not determine the coefficients
  };
  /// The change as a sentence, for those who may allocate.
  static Status ToStatus(Change change);

  /// A removal that would leave less than this part of the matrix's determinant is refused.
  static constexpr double LeastRemainder = 1e-6;

  /// A fit without samples; Start makes it usable.
  IncrementalFit() : IncrementalFit(0) {}
  explicit IncrementalFit(int degree);

  /// Takes the first samples, numbered 0, 1, ... in their order (those of weight zero too), and
  /// room for `capacity` samples at once. Minimises scale sum w (r - R(u))^2 + strength times the
  /// roughness of FitSphericalHarmonics, where scale is 4 pi over the sum of these first weights
  /// and stays when samples come and go. Refuses what CheckSamples refuses, a negative strength,
  /// and samples that leave the degree undetermined. Allocates.
  Status Start(const RadialSamples& samples, double strength, std::size_t capacity);
  /// The same fit from the samples at hand, without the rounding of earlier changes. Not for a
  /// servo tick: about a millisecond for 4,002 samples at degree 12, and it may allocate.
  Status Restart();

  /// `number` gets what later calls name the sample with; unchanged where it is refused.
  Change Add(const Vector3& direction, double radius, double weight, std::size_t& number) noexcept;
  Change SetRadius(std::size_t number, double radius) noexcept;
  Change Remove(std::size_t number) noexcept;

  int Degree() const noexcept { return this->Solver.Degree(); }
  /// (degree + 1)^2 of them, mm.
  const double* Coefficients() const noexcept { return this->Values.data(); }
  /// Samples at hand.
  std::size_t Count() const noexcept { return this->Samples.Radii.size() - this->Free.size(); }
  double Scale() const noexcept { return this->WeightScale; }

private:
  bool Knows(std::size_t number) const noexcept;
  double Weight(std::size_t number) const noexcept;
  double FindGain(const Vector3& direction) noexcept;
  void Move(double step) noexcept;
  double Predict() const noexcept;

  MomentSolver Solver;
  SphericalHarmonicBasis Basis;
  RadialSamples Samples; // as many as there is room for; weight zero where unused
  std::vector<char> Used;
  std::vector<std::size_t> Free;
  double Strength = 0.0;
  double WeightScale = 0.0;
  PackedTriangle Inverse;
  CacheLineVector<double> Values;
  CacheLineVector<double> Harmonics;
  CacheLineVector<double> Gain;
};
} // namespace palpate
