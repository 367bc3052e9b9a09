#pragma once

#include "InsideKernel.h"
#include "InstructionSet.h"

namespace palpate::inside
{
/// The kernel for an instruction set that this processor has.
const Kernel& KernelFor(InstructionSet set) noexcept;
} // namespace palpate::inside
