#pragma once

#include "InstructionSet.h"

#include <vector>

namespace palpate::test
{
/// Every set that this processor supports, Portable first.
inline std::vector<InstructionSet> RunnableInstructionSets()
{
  std::vector<InstructionSet> sets{InstructionSet::Portable};
  if (FastestInstructionSet() != InstructionSet::Portable)
  {
    sets.push_back(FastestInstructionSet());
  }
  return sets;
}

inline const char* NameOf(InstructionSet set) noexcept
{
  return set == InstructionSet::Avx2 ? "avx2" : "portable";
}
} // namespace palpate::test
