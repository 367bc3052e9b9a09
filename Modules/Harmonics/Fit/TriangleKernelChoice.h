#pragma once

#include "InstructionSet.h"
#include "TriangleKernel.h"

namespace palpate::triangle
{
/// The kernel for an instruction set that this processor supports.
const Kernel& KernelFor(InstructionSet set) noexcept;
} // namespace palpate::triangle
