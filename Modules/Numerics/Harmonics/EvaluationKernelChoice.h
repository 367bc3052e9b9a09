#pragma once

#include "EvaluationKernel.h"
#include "InstructionSet.h"

namespace palpate
{
/// The kernels for an instruction set that this processor supports.
template <typename Real>
const EvaluationKernels<Real>& KernelsFor(InstructionSet set) noexcept;
template <>
const EvaluationKernels<double>& KernelsFor<double>(InstructionSet set) noexcept;
template <>
const EvaluationKernels<float>& KernelsFor<float>(InstructionSet set) noexcept;
} // namespace palpate
