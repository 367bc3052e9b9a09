#pragma once

#include "RemovedDistances.h"
#include "Status.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace palpate
{
/// A state of what was removed as bytes, to be kept in a file: little-endian; the blocks that
/// differ from nothing removed, in the order of memory, those of one value by that alone. The same
/// state gives the same bytes.
std::vector<std::byte> BytesOf(const RemovedDistances& removed);

/// Refuses bytes that are no such state, or one of another grid or band than `like` has.
Status RemovedFromBytes(const std::vector<std::byte>& bytes, const RemovedDistances& like,
                        std::shared_ptr<const RemovedDistances>& removed);
} // namespace palpate
