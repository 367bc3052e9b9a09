// Compiled for AVX2 and FMA (see CMakeLists.txt), so this file must not include anything that
// another file includes; see Quartet.h.
#include "EvaluationKernelsAvx2.h"

// Registers are scarce: GCC does better if it schedules the instructions before register
// allocation.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("schedule-insns", "sched-pressure")
#endif

#include "EvaluationKernelsOf.h"

namespace palpate::evaluation
{
namespace
{
struct Avx2Set
{
  using Real = double;
  typedef double Vector __attribute__((vector_size(32)));
  typedef double StoredVector __attribute__((vector_size(32), aligned(8), may_alias));
  static constexpr int Lanes = 4;
  typedef double PointVector __attribute__((vector_size(32)));
  static constexpr int Points = 4;
  // 2^256
  static constexpr int ScaleBits = 256;
  static constexpr double ScaleUp = 0x1p256;

  // The empty asm statement hides that all lanes are equal: GCC would compute with one and
  // broadcast the results, which is slower.
  static PALPATE_INLINE Vector Spread(double value)
  {
    Vector result = value - Vector{};
    asm("" : "+x"(result));
    return result;
  }
};
} // namespace

const EvaluationKernels Avx2 = KernelsOf<Avx2Set>();
} // namespace palpate::evaluation
