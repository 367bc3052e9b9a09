#pragma once

#include "EvaluationKernel.h"

namespace palpate::evaluation
{
/// For x86-64 with AVX2 and FMA only.
extern const EvaluationKernels<double> Avx2Double;
extern const EvaluationKernels<float> Avx2Float;
} // namespace palpate::evaluation
