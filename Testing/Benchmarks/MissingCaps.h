#pragma once

#include "DirectionCoverage.h"

#include <string>
#include <vector>

namespace palpate::bench
{
/// Effect of a missing cap of directions on a fit, with one kind of penalty. Errors are absolute
/// differences of the radius from the true one (mm), largest over several bodies, at the directions
/// of a full sphere: outside and inside the cap.
struct MissingCapRow
{
  double CapDegrees;   ///< radius of the missing cap; 0: none
  const char* Penalty; ///< "none", "cross-validation" or "1e-3"
  double Strength;     ///< of the penalty, the median over the bodies
  double Condition;    ///< without penalty
  double NoiseGainRms;
  double NoiseGainMaximum;
  double ErrorOutside; ///< mm
  double ErrorInside;  ///< mm; 0 if no cap is missing
  DirectionCoverage::Verdict Verdict;
  std::string Message;
};

/// Organ-like bodies of degree 12 (20 mm), 4,002 directions without the cap, noise of 0.3 mm, fits
/// of degree 12. One row for each cap of 0, 10, ... 60 degrees and each penalty. Takes seconds.
std::vector<MissingCapRow> MissingCaps(int bodies);

/// The rows as a table in Markdown.
std::string ToMarkdown(const std::vector<MissingCapRow>& rows);
} // namespace palpate::bench
