#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

/// Structure-aware mutations: they change fields, lengths, indices and nesting, so that inputs get
/// past a reader's first checks. Results depend only on the bytes and the random numbers.
namespace palpate::test
{
using Random = std::mt19937_64;

/// Changes an input in place.
using Mutator = std::function<void(std::string& bytes, Random& random)>;

/// A number from 0 to `count` - 1; 0 if `count` is 0.
std::size_t Below(Random& random, std::size_t count);

template <typename List>
const auto& Choose(const List& list, Random& random)
{
  return list[Below(random, std::size(list))];
}

/// Applies one of several mutators, chosen at random.
Mutator OneOf(std::vector<Mutator> mutators);

/// Applies a mutator to the bytes after a mark, or to all if the mark is missing.
Mutator Behind(std::string mark, Mutator mutator);

/// For any format: flips bytes, truncates, repeats, copies or removes a part, appends bytes.
void MutateBytes(std::string& bytes, Random& random);

/// A boundary value: 0, -1, the limits of every width, factors whose products overflow 32 or 64
/// bits, or the present value plus or minus 1, doubled or negated. The caller truncates it.
std::uint64_t OddInteger(std::uint64_t present, Random& random);
/// The same for floating-point fields: signed zeros, infinities, NaN, subnormal and huge numbers.
double OddReal(double present, Random& random);
/// A boundary value as text, or a spelling that parsers disagree about.
std::string OddNumberText(Random& random);
} // namespace palpate::test
