#pragma once

#include "ElasticPhantom.h"
#include "FreePlace.h"

#include <cstdint>
#include <random>

namespace palpate::test
{
/// A hand that presses a ball into a phantom: not quite where and how deep it means to, and with a
/// sense of force as blurred as that of people. The same seed gives the same errors in the same
/// order.
class PalpatingHand
{
public:
  static constexpr double Depth = 3.0; ///< mm; linear elasticity holds up to 4 with this ball
  /// Standard deviations of the errors of one press, normally distributed. Those of the hand are
  /// assumed: physiological tremor is of the order of 0.1 mm. That of the percept follows from the
  /// just noticeable difference, if it is the increment that one presentation tells with d' = 1.
  static constexpr double DepthDeviation = 0.1;   ///< mm
  static constexpr double PlaceDeviation = 1.0;   ///< mm, along each axis
  static constexpr double PerceptDeviation = 1.0; ///< just noticeable differences of the force

  /// Keeps the phantom's address, which must outlive it.
  PalpatingHand(const ElasticPhantom& phantom, std::uint64_t seed);

  /// The force (N) that the hand believes to feel when it means to press at a place.
  double Press(const FreePlace& place);

private:
  double Error(double deviation) { return deviation * this->Normal(this->Random); }

  const ElasticPhantom* Phantom;
  std::mt19937_64 Random;
  std::normal_distribution<double> Normal;
};
} // namespace palpate::test
