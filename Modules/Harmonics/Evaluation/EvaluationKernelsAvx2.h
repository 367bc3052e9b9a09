#pragma once

#include "EvaluationKernel.h"

namespace palpate::evaluation
{
/// For x86-64 with AVX2 and FMA only.
extern const EvaluationKernels Avx2;
} // namespace palpate::evaluation
