#pragma once

#include "Mutation.h"

namespace palpate::test
{
/// What a text format is made of, beside numbers and lines.
struct TextGrammar
{
  /// Keys and values that the format knows; they take each other's places.
  std::vector<std::string> Words;
  /// What opens and closes a level that can be nested.
  std::vector<std::pair<std::string, std::string>> Brackets;
  /// Ends the text of a file that goes on with bytes; empty: all of it is text.
  std::string HeadEnd;
};

/// Changes tokens, keys, values, cells, lines and nesting of a text.
Mutator TextMutator(TextGrammar grammar);

/// `depth` times `open`, then `inner`, then as often `close`.
std::string Nested(std::size_t depth, const std::string& open, const std::string& inner,
                   const std::string& close);
/// A depth of nesting from one to more than a stack of 8 MB holds.
std::size_t OddDepth(Random& random);
} // namespace palpate::test
