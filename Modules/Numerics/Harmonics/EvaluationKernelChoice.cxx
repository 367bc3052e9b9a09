#include "EvaluationKernelChoice.h"

#include "EvaluationKernelsPortable.h"
#if defined(__x86_64__)
#include "EvaluationKernelsAvx2.h"
#endif

namespace palpate
{
template <>
const EvaluationKernels<double>& KernelsFor<double>(InstructionSet set) noexcept
{
#if defined(__x86_64__)
  if (set == InstructionSet::Avx2)
  {
    return evaluation::Avx2Double;
  }
#endif
  return evaluation::PortableDouble;
}

template <>
const EvaluationKernels<float>& KernelsFor<float>(InstructionSet set) noexcept
{
#if defined(__x86_64__)
  if (set == InstructionSet::Avx2)
  {
    return evaluation::Avx2Float;
  }
#endif
  return evaluation::PortableFloat;
}
} // namespace palpate
