#pragma once

#include <vector>

namespace palpate
{
enum class InstructionSet
{
  Portable, ///< any machine
  Avx2      ///< x86-64 with AVX2 and FMA
};

/// The fastest one that this processor has; asked of the processor once.
InstructionSet FastestInstructionSet() noexcept;
/// Every one that this processor has, for tests and benchmarks; Portable comes first.
std::vector<InstructionSet> RunnableInstructionSets();
/// "portable", "avx2".
const char* NameOf(InstructionSet set) noexcept;
} // namespace palpate
