#pragma once

#include "Mutation.h"

namespace palpate::test
{
/// Applies another mutator to the content of a gzip file, sometimes appends megabytes of zeros, and
/// compresses it again; or changes the gzip file itself: header, checksum, length, a second member.
Mutator GzipMutator(Mutator inner);
} // namespace palpate::test
