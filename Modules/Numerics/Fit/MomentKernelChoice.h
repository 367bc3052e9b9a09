#pragma once

#include "InstructionSet.h"
#include "MomentKernel.h"

namespace palpate::moments
{
/// The arithmetic for an instruction set that this processor has.
const Kernel& KernelFor(InstructionSet set) noexcept;
} // namespace palpate::moments
