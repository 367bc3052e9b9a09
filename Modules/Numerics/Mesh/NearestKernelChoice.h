#pragma once

#include "InstructionSet.h"
#include "NearestKernel.h"

namespace palpate::nearest
{
/// The kernel for an instruction set that this processor supports.
const Kernel& KernelFor(InstructionSet set) noexcept;
} // namespace palpate::nearest
