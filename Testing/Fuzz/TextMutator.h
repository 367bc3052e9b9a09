#pragma once

#include "Mutation.h"

namespace palpate::test
{
/// Elements of a text format in addition to numbers and lines.
struct TextGrammar
{
  /// Keys and values of the format, used as replacements.
  std::vector<std::string> Words;
  /// Opening and closing text of a nesting level.
  std::vector<std::pair<std::string, std::string>> Brackets;
  /// Last bytes of the text header of a binary file; empty: the whole file is text.
  std::string HeadEnd;
};

/// Changes tokens, keys, values, cells, lines and nesting of a text.
Mutator TextMutator(TextGrammar grammar);

/// `depth` times `open`, then `inner`, then as often `close`.
std::string Nested(std::size_t depth, const std::string& open, const std::string& inner,
                   const std::string& close);
/// A nesting depth from 1 to 100,000, which overflows a stack of 8 MB if each level recurses.
std::size_t OddDepth(Random& random);
} // namespace palpate::test
