#pragma once

namespace palpate
{
/// What a hand notices of forces, in N: two forces are told apart if they differ by at least one
/// just noticeable difference (JND). Weber's law with a floor, because discrimination gets worse,
/// in parts of the force, below half a newton. Signs of forces are ignored where sizes are meant.
///
/// Kinaesthetic force alone, as one-point devices give it: what skin feels of a pressure's shape is
/// not in it. Sources: Pang, Tan and Durlach, Manual discrimination of force using active finger
/// motion, Perception & Psychophysics 49 (1991) 531-540, about 7 % from 2.5 to 10 N; Jones,
/// Matching forces, Perception 18 (1989) 681-687, 5 to 9 %; the 0.5 N: Jones, Kinesthetic sensing
/// (2000).
class ForcePerception
{
public:
  static constexpr double WeberFraction = 0.07;
  static constexpr double SmallestWeberForce = 0.5; ///< N, below it the JND stays the same

  /// JND at a force, N: 7 % of its size, at least 0.035 N. NaN for NaN.
  static double JustNoticeable(double force);

  /// Difference between a force and a reference, in JNDs of the reference, positive if the force is
  /// larger: it is noticed from 1 and down to -1. NaN for NaN.
  static double Contrast(double force, double reference);
};
} // namespace palpate
