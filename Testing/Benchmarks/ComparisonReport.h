#pragma once

#include "PairedBenchmark.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace palpate::bench
{
/// One line per comparison; the ratio is the speed-up of ours.
void PrintTable(std::ostream& out, const std::vector<Comparison>& comparisons);
/// A list of {"name", "ns", "against", "against_ns", "ratio"}, with "instructions" and
/// "against_instructions" if both were counted.
std::string ToJson(const std::vector<Comparison>& comparisons);
} // namespace palpate::bench
