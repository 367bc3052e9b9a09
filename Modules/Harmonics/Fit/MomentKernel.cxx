// Compiled for AVX2 and FMA (see CMakeLists.txt), so this file must not include anything else. The
// portable kernel is instantiated in MomentKernelChoice.cxx.
#include "MomentKernel.h"

namespace palpate::moments
{
struct Avx2Set
{
  typedef double Vector __attribute__((vector_size(32), may_alias));
  static constexpr int Lanes = 4;
};
using Avx2Arithmetic = Arithmetic<Avx2Set>;

const Kernel Avx2{Avx2Set::Lanes, Avx2Arithmetic::Accumulate, Avx2Arithmetic::Residuals,
                  Avx2Arithmetic::WeightedProducts};
} // namespace palpate::moments
