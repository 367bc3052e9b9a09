#include "InstructionSet.h"

namespace palpate
{
namespace
{
bool HasAvx2() noexcept
{
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}
} // namespace

InstructionSet FastestInstructionSet() noexcept
{
  static const InstructionSet fastest = HasAvx2() ? InstructionSet::Avx2 : InstructionSet::Portable;
  return fastest;
}

std::vector<InstructionSet> RunnableInstructionSets()
{
  std::vector<InstructionSet> sets{InstructionSet::Portable};
  if (HasAvx2())
  {
    sets.push_back(InstructionSet::Avx2);
  }
  return sets;
}

const char* NameOf(InstructionSet set) noexcept
{
  return set == InstructionSet::Avx2 ? "avx2" : "portable";
}
} // namespace palpate
