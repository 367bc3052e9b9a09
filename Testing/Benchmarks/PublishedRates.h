#pragma once

#include <string>
#include <vector>

namespace palpate::bench
{
/// What one way of touching takes and errs by where a published system was measured.
struct PublishedRateRow
{
  std::string System;          ///< empty: the one above
  std::string Touched;         ///< ours
  double TicksPerSecond = 0.0; ///< of a whole servo that runs freely on one core
  double PlaceMean = 0.0;      ///< mm, of the proxy from where the tool just touches the surface
  double PlaceMaximum = 0.0;   ///< mm
  double AngleMean = 0.0;      ///< rad, of the force from the true normal
  double AngleMaximum = 0.0;   ///< rad
  std::string PublishedHertz;  ///< their rate, or empty where they tell none of this way
};

/// What the second system's law asks a volume in a tick.
struct VolumeQuestions
{
  double Rays;               ///< one for each of 26 points that is inside, in the mean
  double SixtyInsideSeconds; ///< that the published number of inside tests takes, and nothing else
};

struct PublishedComparison
{
  std::vector<PublishedRateRow> Rows;
  VolumeQuestions Questions;
};

/// Both founding systems' own comparisons, on bodies that are known exactly: spherical harmonics of
/// degree 12 against as many facets as are drawn of it (8,000), and a sphere tool of 26 points in a
/// volume. Ticks are the shortest of twenty strokes. Some seconds. Throws std::runtime_error where
/// a structure cannot be made.
PublishedComparison ComparePublished();

/// As a table in Markdown and a sentence.
std::string ToMarkdown(const PublishedComparison& comparison);
} // namespace palpate::bench
