#pragma once

#include "TradeSetting.h"

#include <cmath>
#include <string>

namespace palpate
{
/// Thresholds of hands, as the literature has them.
struct TradeThresholds
{
  static constexpr double JustNoticeablePart = 0.07; ///< of a force, from WeighedForce on
  /// N. Below, hands tell differences worse and worse: about 15 to 27 % of it, which is what stays
  /// of 7 % of this.
  static constexpr double WeighedForce = 0.5;
  static constexpr double NoticeableDegrees = 18.0; ///< of a force's direction: the keenest
  /// N. Smaller forces have no direction to speak of.
  static constexpr double LeastForce = 0.02;
  static constexpr double Seizure = 2.0; ///< mm from the true proxy

  /// The difference (N) that is just noticed in a force (N).
  static constexpr double JustNoticeable(double force)
  {
    return JustNoticeablePart * (force > WeighedForce ? force : WeighedForce);
  }
};

/// What one setting costs at one structure and how true it is. Numbers that were not measured are
/// NaN.
struct TradeRow
{
  enum class Outcome
  {
    Measured,
    Refused ///< the structure cannot be represented so; Message says why
  };

  std::string Structure;
  ContactSetting Setting;
  Outcome State = Outcome::Measured;
  std::string Message;
  std::string Represented; ///< in words, as it came to be made
  std::string Truth;       ///< what it was compared with

  // A tick, in ns: the least of several runs, less the clock's own.
  double TickMean = NAN;
  double TickMedian = NAN;
  double TickRare = NAN; ///< 99.9 % take no longer
  double TickLongest = NAN;
  double Rate = NAN; ///< Hz: what TickRare leaves time for, with nothing else to do

  // From the true proxy, mm: as far as it is felt, and along the true normal alone.
  double PositionMean = NAN;
  double PositionRare = NAN; ///< 99 %
  double PositionMost = NAN;
  double SurfaceMean = NAN;
  double SurfaceMost = NAN;

  // From the ideal force, N; and in just noticeable differences of it.
  double ForceMean = NAN;
  double ForceRare = NAN; ///< 99 %
  double ForceMost = NAN;
  double NoticeableMean = NAN;
  double NoticeableRare = NAN; ///< 99 %

  // From the ideal force's direction, degrees.
  double DirectionMean = NAN;
  double DirectionRare = NAN; ///< 99 %
  double DirectionMost = NAN;

  // The force's jump from tick to tick, N.
  double JumpMean = NAN;
  double JumpMost = NAN;
  double IdealJumpMean = NAN;
  double IdealJumpMost = NAN;

  double Seizures = NAN; ///< how often the proxy came to be TradeThresholds::Seizure off

  double BuildSeconds = NAN;
  double Bytes = NAN; ///< of the model, and of what follows it

  bool IsFelt() const { return this->State == Outcome::Measured; }
};
} // namespace palpate
