#pragma once

#include "InstructionSet.h"

#include <cstddef>

namespace palpate::householder
{
/// Reduces a matrix of rows x columns, rows >= columns, column by column to its upper triangle R by
/// Householder reflections; entries below the diagonal are overwritten. `right` (rows numbers)
/// becomes Q^T right. Throws std::bad_alloc if there is no memory for a block of columns.
/// Source: Golub and Van Loan, Matrix Computations, 4th ed., 5.2.2.
using Reduction = void (*)(double* matrix, std::ptrdiff_t rows, std::ptrdiff_t columns,
                           double* right);

/// For an instruction set that this processor supports. Results differ by rounding.
Reduction ReductionFor(InstructionSet set) noexcept;
} // namespace palpate::householder
