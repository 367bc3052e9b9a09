#pragma once

#include "DirectionCoverage.h"

#include <string>
#include <vector>

namespace palpate::bench
{
/// What a missing cap of directions does to a fit, with one kind of penalty. Errors are absolute
/// differences of the radius from the true one (mm), largest over several bodies, at the directions
/// of a full sphere: outside of the cap and inside of it.
struct MissingCapRow
{
  double CapDegrees;   ///< radius of the cap that is missing; 0: none is
  const char* Penalty; ///< "none", "cross-validation" or "1e-3"
  double Strength;     ///< of the penalty, the median over the bodies
  double Condition;    ///< without penalty
  double NoiseGainRms;
  double NoiseGainMaximum;
  double ErrorOutside; ///< mm
  double ErrorInside;  ///< mm; 0 where no cap is missing
  DirectionCoverage::Verdict Verdict;
  std::string Sentence;
};

/// Organ-like bodies of degree 12 (20 mm), 4,002 directions less the cap, noise of 0.3 mm, fits of
/// degree 12. One row for each cap of 0, 10, ... 60 degrees and each penalty. Seconds.
std::vector<MissingCapRow> MissingCaps(int bodies);

/// The rows as a table in Markdown.
std::string ToMarkdown(const std::vector<MissingCapRow>& rows);
} // namespace palpate::bench
