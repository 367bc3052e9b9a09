#pragma once

#include "InsideKernel.h"
#include "InstructionSet.h"

namespace palpate::inside
{
/// The kernel for an instruction set, which this processor must support.
const Kernel& KernelFor(InstructionSet set) noexcept;
} // namespace palpate::inside
