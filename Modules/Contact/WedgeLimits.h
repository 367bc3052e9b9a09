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
  static constexpr int Steps = 6;                // of a slide
  static constexpr int Proofs = 12;              // of a tick
  static constexpr int EvaluationsOfProof = 640; // unless the work of a tick is counted
  static constexpr int EvaluationsAhead = 160;
  // Error of a wall's parameter, rad: that of its distance is the square of it.
  static constexpr double Tracking = 1e-7;
};
} // namespace palpate
