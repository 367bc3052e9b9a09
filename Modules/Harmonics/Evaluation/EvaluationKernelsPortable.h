#pragma once

#include "EvaluationKernel.h"

namespace palpate::evaluation
{
/// For any machine: vectors of 16 bytes are SSE2 on x86-64 and NEON on arm64.
extern const EvaluationKernels Portable;
} // namespace palpate::evaluation
