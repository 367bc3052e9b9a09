#pragma once

namespace palpate
{
enum class InstructionSet
{
  Portable, ///< any machine
  Avx2      ///< x86-64 with AVX2 and FMA
};

/// The fastest set that this processor supports; detected once.
InstructionSet FastestInstructionSet() noexcept;
} // namespace palpate
