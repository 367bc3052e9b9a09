#pragma once

#include "PairedBenchmark.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace palpate::bench
{
/// One line a comparison; the ratio is how many times faster ours is. Instructions where they were
/// counted, for one item like the times.
void PrintTable(std::ostream& out, const std::vector<Comparison>& comparisons);
/// A list of {"name", "ns", "against", "against_ns", "ratio"}, and "instructions" and
/// "against_instructions" where they were counted.
std::string ToJson(const std::vector<Comparison>& comparisons);
} // namespace palpate::bench
