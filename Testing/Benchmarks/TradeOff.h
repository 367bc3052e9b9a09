#pragma once

#include "PairedBenchmark.h"

#include <string>
#include <vector>

namespace palpate::bench
{
/// Radius and gradient at several degrees, by every formulation, one direction a call and many:
/// against the recurrence, one direction a call.
std::vector<PairedBenchmark> TradeOffBenchmarks();

/// What one of those costs and brings, for an organ-like body of 25 mm that has terms up to degree
/// 96.
struct TradeOffRow
{
  int Degree;
  std::string Formulation;       ///< "polynomials", "recurrence"
  std::string Calls;             ///< "one", "batch"
  double Nanoseconds;            ///< for one direction
  double RoundingMillimeters;    ///< largest error of the radius of the truncated body
  double LostRmsMillimeters;     ///< what the degree leaves out of the body
  double LostMaximumMillimeters; ///< the same, largest of 4,002 directions
};

/// The rows for those of the comparisons that are trade-off benchmarks.
std::vector<TradeOffRow> TradeOffRows(const std::vector<Comparison>& comparisons);

/// A list of objects, one a row.
std::string ToJson(const std::vector<TradeOffRow>& rows);
} // namespace palpate::bench
