#pragma once

#include "RemovedDistances.h"
#include "Status.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace palpate
{
/// Serialises a state of removal for a file: little-endian; the blocks that differ from nothing
/// removed, in memory order, uniform ones as one value. Equal states give equal bytes.
std::vector<std::byte> BytesOf(const RemovedDistances& removed);

/// Fails for bytes that are not such a state, and for a grid or band other than that of `like`.
Status RemovedFromBytes(const std::vector<std::byte>& bytes, const RemovedDistances& like,
                        std::shared_ptr<const RemovedDistances>& removed);
} // namespace palpate
