#pragma once

#include <string>
#include <vector>

namespace palpate::bench
{
/// Cost and quality of one touch model over a minute of touch, at 1 kHz.
struct TouchQualityRow
{
  std::string Name;
  double MedianNanoseconds; ///< of a tick
  double RareNanoseconds;   ///< not exceeded by 99.9 % of the ticks
  double LongestNanoseconds;
  double SurfaceMean; ///< mm, distance of the contact point from the true surface
  double SurfaceMaximum;
  double AngleMean; ///< rad, between the force and the ideal one
  double AngleRare; ///< not exceeded by 99 %
  double AngleMaximum;
  double JumpMean; ///< change of the force from one tick to the next, relative to the force
  double JumpMaximum;
  double IdealJumpMean; ///< of the force from the exact closest point
  double IdealJumpMaximum;
  int Seizures; ///< number of times the proxy got more than 2 mm from the true one
};

/// A tool slides over a body of 25 mm with bumps of degrees 3 and 4, at 20 to 100 mm/s, 0.5 to 3 mm
/// deep, 60,000 ticks, for each representation. Each tick is the shortest of five runs of the same
/// path, which excludes disturbances, minus the clock's own time. About two minutes. Throws
/// std::runtime_error if a structure cannot be made.
std::vector<TouchQualityRow> TouchQuality();

/// The rows as a table in Markdown.
std::string ToMarkdown(const std::vector<TouchQualityRow>& rows);
} // namespace palpate::bench
