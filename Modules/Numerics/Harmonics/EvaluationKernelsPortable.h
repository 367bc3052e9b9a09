#pragma once

#include "EvaluationKernel.h"

namespace palpate::evaluation
{
/// Portable: vectors of 16 bytes are SSE2 on x86-64 and NEON on arm64.
extern const EvaluationKernels<double> PortableDouble;
extern const EvaluationKernels<float> PortableFloat;
} // namespace palpate::evaluation
