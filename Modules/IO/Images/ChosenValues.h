#pragma once

#include "PalpateIOModule.h"
#include "ValueChoice.h"
#include "Volume.h"

namespace palpate
{
/// Applies a choice of values to a volume that was read, with a note that counts the voxels. Throws
/// InputError if no voxel reaches the threshold, and if the mask does not fit into memory.
PALPATEIO_EXPORT void ChooseValues(const ValueChoice& choice, Volume& volume);
} // namespace palpate
