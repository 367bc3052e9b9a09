#pragma once

#include <string>
#include <vector>

namespace palpate::bench
{
/// What one way of touching costs and is worth over a minute of touch, at 1 kHz.
struct TouchQualityRow
{
  std::string Name;
  double MedianNanoseconds; ///< of a tick
  double RareNanoseconds;   ///< which 99.9 % of the ticks do not exceed
  double LongestNanoseconds;
  double SurfaceMean; ///< mm, of the touched place from the true surface
  double SurfaceMaximum;
  double AngleMean; ///< rad, between the force and the ideal one
  double AngleRare; ///< which 99 % do not exceed
  double AngleMaximum;
  double JumpMean; ///< of forces from one tick to the next, part of the force
  double JumpMaximum;
  double IdealJumpMean; ///< of the force from the exact nearest point
  double IdealJumpMaximum;
  int Seizures; ///< how often a proxy came to be more than 2 mm from the true one
};

/// A tool slides over a body of 25 mm with bumps of degrees 3 and 4, at 20 to 100 mm/s, 0.5 to 3 mm
/// deep, 60,000 ticks: for each representation. Each tick is the shortest of five runs of the same
/// path, so that what else a machine does is left out, less what the clock takes itself. About two
/// minutes. Throws std::runtime_error where a structure cannot be made.
std::vector<TouchQualityRow> TouchQuality();

/// The rows as a table in Markdown.
std::string ToMarkdown(const std::vector<TouchQualityRow>& rows);
} // namespace palpate::bench
