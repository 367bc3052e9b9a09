#pragma once

#include <cstddef>

namespace palpate::householder
{
/// A Reduction compiled for AVX2 and FMA.
void ReduceByAvx2(double* matrix, std::ptrdiff_t rows, std::ptrdiff_t columns, double* right);
} // namespace palpate::householder
