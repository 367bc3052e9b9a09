#pragma once

#include "InstructionSet.h"
#include "RayKernel.h"
#include "ScalarType.h"

namespace palpate::rays
{
/// The kernel for an instruction set that this processor has.
const Kernel& KernelFor(InstructionSet set) noexcept;
/// A stored type's number in the kernel; of 32 bits and more only floating point is stored.
int NumberOf(ScalarType type) noexcept;
} // namespace palpate::rays
