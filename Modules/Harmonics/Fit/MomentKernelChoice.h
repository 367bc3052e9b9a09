#pragma once

#include "InstructionSet.h"
#include "MomentKernel.h"

namespace palpate::moments
{
/// The kernel for an instruction set that this processor supports.
const Kernel& KernelFor(InstructionSet set) noexcept;
} // namespace palpate::moments
