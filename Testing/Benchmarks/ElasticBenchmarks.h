#pragma once

#include "PairedBenchmark.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::bench
{
/// The force of an organ that yields, a tick, for maps of several degrees: against GSL's value and
/// gradient of the same maps and the same equation of contact.
std::vector<PairedBenchmark> ElasticBenchmarks();

/// What a degree of the maps costs and brings.
struct ElasticMapRow
{
  int Degree;
  std::size_t Bytes;  ///< of what the servo reads
  double LostRms;     ///< of the compliance, relative
  double LostLargest; ///< the same at the worst of some hundred places
  double Nanoseconds; ///< of a tick
  double Ratio;       ///< times faster than the alternative
};

/// A bumpy organ of 20 mm with a lesion of three times the modulus, 2 mm below its surface, for
/// those of the comparisons that are of ElasticBenchmarks. Some ten seconds. Throws
/// std::runtime_error if it cannot be made.
std::vector<ElasticMapRow> ElasticMapRows(const std::vector<Comparison>& comparisons);

/// The rows as a table in Markdown.
std::string ToMarkdown(const std::vector<ElasticMapRow>& rows);
} // namespace palpate::bench
