#pragma once

#include "Mutation.h"

namespace palpate::test
{
/// Changes the values, keys, lists and nesting of a JSON text, and then often its tokens and lines
/// (repeated keys among them). `words` are keys and values that the format knows. Text that is no
/// JSON is changed as text alone.
Mutator JsonMutator(std::vector<std::string> words);
} // namespace palpate::test
