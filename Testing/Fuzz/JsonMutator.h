#pragma once

#include "Mutation.h"

namespace palpate::test
{
/// Changes values, keys, lists and nesting of a JSON text, and sometimes its tokens and lines
/// (which gives repeated keys). `words` are keys and values of the format. Malformed JSON is
/// mutated as plain text.
Mutator JsonMutator(std::vector<std::string> words);
} // namespace palpate::test
