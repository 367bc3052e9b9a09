#pragma once

#include <string>
#include <vector>

namespace palpate::bench
{
/// Cost and errors of one touch model, measured where a published system was.
struct PublishedRateRow
{
  std::string System;          ///< empty: as in the previous row
  std::string Touched;         ///< ours
  double TicksPerSecond = 0.0; ///< of a whole servo that runs freely on one core
  double PlaceMean = 0.0;      ///< mm, of the proxy from where the tool just touches the surface
  double PlaceMaximum = 0.0;   ///< mm
  double AngleMean = 0.0;      ///< rad, of the force from the true normal
  double AngleMaximum = 0.0;   ///< rad
  std::string PublishedHertz;  ///< the published rate, or empty if there is none for this model
};

/// Queries of the second system's law to a volume per tick.
struct VolumeQuestions
{
  double Rays;               ///< one for each of 26 points that is inside, on average
  double SixtyInsideSeconds; ///< for the published number of inside tests only
};

struct PublishedComparison
{
  std::vector<PublishedRateRow> Rows;
  VolumeQuestions Questions;
};

/// The comparisons of both original publications, on exactly known bodies: spherical harmonics of
/// degree 12 against as many facets as are drawn of it (8,000), and a spherical tool of 26 points
/// in a volume. Ticks are the shortest of twenty strokes. Takes seconds. Throws std::runtime_error
/// if a structure cannot be made.
PublishedComparison ComparePublished();

/// As a table in Markdown and a sentence.
std::string ToMarkdown(const PublishedComparison& comparison);
} // namespace palpate::bench
