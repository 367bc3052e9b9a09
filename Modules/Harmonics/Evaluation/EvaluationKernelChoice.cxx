#include "EvaluationKernelChoice.h"

#include "EvaluationKernelsPortable.h"
#if defined(__x86_64__)
#include "EvaluationKernelsAvx2.h"
#endif

namespace palpate
{
const EvaluationKernels& EvaluationKernelsFor(InstructionSet set) noexcept
{
#if defined(__x86_64__)
  if (set == InstructionSet::Avx2)
  {
    return evaluation::Avx2;
  }
#endif
  return evaluation::Portable;
}
} // namespace palpate
