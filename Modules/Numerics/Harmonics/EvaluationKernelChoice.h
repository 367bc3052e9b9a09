#pragma once

#include "EvaluationKernel.h"
#include "InstructionSet.h"

namespace palpate
{
/// The kernels for an instruction set that this processor has.
const EvaluationKernels& KernelsFor(InstructionSet set) noexcept;
} // namespace palpate
