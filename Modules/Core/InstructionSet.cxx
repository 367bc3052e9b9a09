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
} // namespace palpate
