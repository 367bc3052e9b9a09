#pragma once

#include "EvaluationKernel.h"
#include "InstructionSet.h"

namespace palpate
{
/// The kernels of an instruction set, which the processor must support.
const EvaluationKernels& EvaluationKernelsFor(InstructionSet set) noexcept;
} // namespace palpate
