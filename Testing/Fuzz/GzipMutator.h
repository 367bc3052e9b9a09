#pragma once

#include "Mutation.h"

namespace palpate::test
{
/// Changes what is packed in a gzip file by another mutator and packs it again, sometimes with
/// megabytes of zeros behind it; or changes the gzip file itself: header, checksum, length, a
/// second member.
Mutator GzipMutator(Mutator inner);
} // namespace palpate::test
