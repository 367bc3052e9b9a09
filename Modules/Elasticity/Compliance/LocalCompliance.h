#pragma once

#include "ElasticBed.h"
#include "HertzPatch.h"
#include "HexElasticity.h"
#include "Vector3.h"

#include <array>
#include <cstddef>

namespace palpate
{
/// The part of a patch's compliance that harmonics up to a degree can't carry: that of a half-space
/// under the patch's shorter waves,
///
///     1/(2 pi) integral of k P(ka)^2 (1 - w(k R')^2) / (E*(k) k/2 + k_b) dk,
///
/// with the window w of ReducedCompliance, R' = |x| / ((1 + n.d)/2), and the modulus E*(k) that a
/// wave feels: a mean over the depth z with the strain energy 4k (kz)^2 exp(-2kz) of an
/// incompressible half-space, where E* at a depth is a mean over the patch. It is the mean of 1/E*,
/// but below tissue that lies on softer ground that of the root of E*, squared: the power was found
/// by comparison with layered spheres (cores of 0.3 to 0.01 of the modulus, 3 to 10 mm down).
class LocalCompliance
{
public:
  /// `degree` is that of the harmonics. Keeps the address of the solid, which must outlive it.
  LocalCompliance(const ElasticSolid& solid, const Vector3& centerWorld, int degree);

  /// mm/N.
  double At(const HertzPatch& patch) const;

private:
  static constexpr std::size_t Depths = 56;
  // 1 / E* at each depth below the patch, mm^2/N.
  std::array<double, Depths> SoftnessBelow(const HertzPatch& patch) const;
  double Softness(const std::array<double, Depths>& below, double waveNumber) const;

  const ElasticSolid* Solid;
  Vector3 CenterWorld;
  int Degree;
  std::array<double, Depths> Nodes;  // mm
  std::array<double, Depths> Limits; // the end of each node's part of the depth, mm
};
} // namespace palpate
