#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

/// Mutations that know formats: they change fields, lengths, indices and nesting, so that inputs
/// get past a reader's first checks. Each result follows from the bytes and the random numbers
/// alone.
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

/// One of several, chosen each time.
Mutator OneOf(std::vector<Mutator> mutators);

/// Changes only what lies behind a mark, or everything where the mark is missing.
Mutator Behind(std::string mark, Mutator mutator);

/// Whatever the format: flips bytes, cuts the end, repeats, moves or removes a part, adds bytes.
void MutateBytes(std::string& bytes, Random& random);

/// A whole number that readers stumble over: 0, -1, the ends of every width, products that overflow
/// 32 and 64 bits, or a neighbour, double or negative of the present one. To be cut to its width.
std::uint64_t OddInteger(std::uint64_t present, Random& random);
/// A number of the same kind for floating-point fields.
double OddReal(double present, Random& random);
/// A number as text: the same, and spellings that parsers disagree about.
std::string OddNumberText(Random& random);
} // namespace palpate::test
