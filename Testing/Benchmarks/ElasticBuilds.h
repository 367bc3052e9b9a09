#pragma once

#include <string>
#include <vector>

namespace palpate::bench
{
/// Cost and accuracy of finite elements and harmonics for an elastic sphere.
struct ElasticBuildRow
{
  int ElementsAcross;
  int Degree;             ///< of the reduced compliance
  bool HasCore;           ///< a core of four times the modulus, 5 mm below the surface
  double Seconds;         ///< from the model to the reduced compliance
  double Mebibytes;       ///< that it takes at most meanwhile
  double ComplianceError; ///< largest, relative: patches of 0.5 to 8 mm, five directions
  double ForceError;      ///< the same of a ball of 8 mm, 0.5 to 4 mm deep
};

/// A sphere of 25 mm, 20 kPa, on a bed of 1 kPa/mm, in 8, 12 and 16 elements across, with harmonics
/// up to degree 8, 12 and 16: against the closed form of the sphere and exact unilateral contact.
/// Some minutes. Throws std::runtime_error if a compliance cannot be made.
std::vector<ElasticBuildRow> ElasticBuilds();

/// The rows as a table in Markdown.
std::string ToMarkdown(const std::vector<ElasticBuildRow>& rows);
} // namespace palpate::bench
