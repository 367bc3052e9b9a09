#pragma once

#include "TradeSetting.h"

#include <cmath>
#include <string>

namespace palpate
{
/// Perception thresholds of hands, from the literature.
struct TradeThresholds
{
  static constexpr double JustNoticeablePart = 0.07; ///< of a force, from WeighedForce on
  /// N. Below, relative discrimination worsens to about 15 to 27 % of the force, which is
  /// approximated by a constant 7 % of this.
  static constexpr double WeighedForce = 0.5;
  static constexpr double NoticeableDegrees = 18.0; ///< of a force's direction; the lowest value
  /// N. The direction of smaller forces is ignored.
  static constexpr double LeastForce = 0.02;
  static constexpr double Seizure = 2.0; ///< mm from the reference proxy

  /// The just noticeable difference (N) of a force (N).
  static constexpr double JustNoticeable(double force)
  {
    return JustNoticeablePart * (force > WeighedForce ? force : WeighedForce);
  }
};

/// Cost and accuracy of one setting at one structure. Numbers that were not measured are NaN.
struct TradeRow
{
  enum class Outcome
  {
    Measured,
    Refused ///< the structure cannot be represented this way; Message gives the reason
  };

  std::string Structure;
  ContactSetting Setting;
  bool Yields = false; ///< the structure does: its forces are compared, not its positions
  Outcome State = Outcome::Measured;
  std::string Message;
  std::string Represented; ///< description of the contact as made
  std::string Truth;       ///< description of the reference

  // Tick time, ns: the minimum over several runs, less the clock's overhead.
  double TickMean = NAN;
  double TickMedian = NAN;
  double TickRare = NAN; ///< 99.9 % quantile
  double Rate = NAN;     ///< Hz: 1 / TickRare, with no other work

  // Position errors from the reference proxy, mm: as felt in the force, and along the reference
  // normal alone. Not of a structure that yields.
  double PositionMean = NAN;
  double PositionRare = NAN; ///< 99 %
  double PositionMost = NAN;
  double SurfaceMean = NAN;
  double SurfaceMost = NAN;

  // Force errors, N, and in just noticeable differences of the ideal force.
  double ForceMean = NAN;
  double ForceRare = NAN; ///< 99 %
  double NoticeableMean = NAN;
  double NoticeableRare = NAN; ///< 99 %

  // Direction errors from the ideal force, degrees.
  double DirectionMean = NAN;
  double DirectionRare = NAN; ///< 99 %
  double DirectionMost = NAN;

  // Errors (99 %) beyond the reference's uncertainty, by which settings are judged: only these are
  // known to be errors. The uncertainty itself, mm: how far the reference's proxy may be off.
  double BeyondPositionRare = NAN;   ///< mm
  double BeyondNoticeableRare = NAN; ///< just noticeable differences of force
  double BeyondDirectionRare = NAN;  ///< degrees
  double UncertaintyMean = NAN;
  double UncertaintyRare = NAN; ///< 99 %

  // Jumps of the force from tick to tick, N.
  double JumpMean = NAN;
  double JumpMost = NAN;
  double IdealJumpMost = NAN;

  /// How often the position error came to exceed the uncertainty by TradeThresholds::Seizure; of a
  /// structure that yields, the error of the proxy on its shape at rest.
  double Seizures = NAN;
  /// Strokes during which the hand, which follows the reference, parted from the tool: a seizure at
  /// more than twice the path's depth. No hand presses on there, so all other numbers of errors,
  /// jumps and seizures leave these strokes out.
  double Parted = NAN;

  double BuildSeconds = NAN; ///< reading excluded; preparing and fitting included
  /// CPU time, s: BuildSeconds and ten minutes of ticks at the servo's rate.
  double CostSeconds = NAN;
  double Bytes = NAN; ///< of the model and its tracker

  bool IsFelt() const { return this->State == Outcome::Measured; }
};
} // namespace palpate
