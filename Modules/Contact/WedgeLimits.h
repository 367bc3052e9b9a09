#pragma once

namespace palpate
{
/// How exact a ContactWedge is, and how much work it may do.
struct WedgeLimits
{
  // Relative to the smallest radius, so that units do not matter: the path between two proofs,
  // where a slide ends, and how deep the sphere may be in a wall that is not known yet. At a
  // surface model that is about 0.01 mm, and what is left to the next tick 0.03 mm, less than
  // a hand feels: for less, many more ticks take long.
  static constexpr double RelativeStep = 1.0 / 16.0;
  static constexpr double RelativeEnd = 6e-6;
  template <typename Surface>
  static constexpr double RelativeTolerance = Surface::MayCrossItself ? 1e-3 : 1e-5;
  // Of the margin that a surface adds to tools: the tool itself is still kept off.
  static constexpr double PartOfMargin = 0.4;
  // Relative to the sphere's radius: nothing is nearer to its centre anywhere, even if a tick has
  // no time for the whole proof.
  static constexpr double LeastProven = 0.5;
  static constexpr int Steps = 6;
  // At a surface model a proof takes much longer: a sphere that has farther to go arrives
  // later.
  static constexpr int Proofs = 12;
  static constexpr int ProofsAtFolds = 3;
  // Where the surface crosses itself steps are as short as the margin: as many as their work
  // allows.
  static constexpr int ProofsAtCrossings = 7;
  static constexpr int EvaluationsOfMove = 640;
  // Of all proofs of a tick; the rest is left to the next ones.
  static constexpr int EvaluationsAtFolds = 10;
  static constexpr int LeastEvaluations = 8; // of each of them
  static constexpr int MoreAtCrossings = 24; // evaluations, for more than the usual proofs
  // Evaluations where they leave much: with 16 instead of 20 a wall in some 10^5 ticks is found so
  // late that the force is wrong. Surfaces that cross themselves, with their small spheres, need
  // more.
  static constexpr int RestOf(bool isOfCrossing) noexcept { return isOfCrossing ? 160 : 20; }
  // Of the smallest radius: how far a sphere that is behind its goal may move in a tick whose
  // EvaluationsAtFolds are used up.
  static constexpr double RelativeMove = 1.0 / 64.0;
  // Of the smallest radius: how deep in the sphere parts may be that are left.
  static constexpr double RelativeSlack = 3e-3;
  static constexpr int EvaluationsAhead = 160;
  static constexpr int EvaluationsOfPreparation = 12; // of each tick near a hollow
  // Error of a wall's parameter, rad: that of its distance is the square of it.
  static constexpr double Tracking = 1e-7;
};
} // namespace palpate
