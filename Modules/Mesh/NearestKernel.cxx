// Compiled for AVX2 and FMA (see CMakeLists.txt), so this file must not include anything else. The
// portable kernel is instantiated in NearestOnMesh.cxx.
#include "NearestKernel.h"

namespace palpate::nearest
{
struct Avx2Set
{
  typedef double Vector __attribute__((vector_size(32)));
  typedef long long Integers __attribute__((vector_size(32)));
  static constexpr int Lanes = 4;

  static inline __attribute__((always_inline)) bool Any(const Integers& lanes)
  {
#if defined(__AVX__)
    return __builtin_ia32_movmskpd256((Vector)lanes) != 0;
#else // compiled, never selected
    return (lanes[0] | lanes[1] | lanes[2] | lanes[3]) != 0;
#endif
  }
};

const Kernel Avx2{Arithmetic<Avx2Set>::Find};
} // namespace palpate::nearest
