#pragma once

#include "InstructionSet.h"
#include "TriangleKernel.h"

namespace palpate::triangle
{
/// The arithmetic for an instruction set that this processor has.
const Kernel& KernelFor(InstructionSet set) noexcept;
} // namespace palpate::triangle
