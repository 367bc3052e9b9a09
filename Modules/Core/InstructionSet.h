#pragma once

#include <vector>

namespace palpate
{
enum class InstructionSet
{
  Portable, ///< any machine
  Avx2      ///< x86-64 with AVX2 and FMA
};

/// The fastest set that this processor supports; detected once.
InstructionSet FastestInstructionSet() noexcept;
/// Every set that this processor supports, Portable first; for tests and benchmarks.
std::vector<InstructionSet> RunnableInstructionSets();
/// "portable", "avx2".
const char* NameOf(InstructionSet set) noexcept;
} // namespace palpate
