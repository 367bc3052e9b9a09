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
struct Avx2DoubleSet
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

struct Avx2FloatSet
{
  using Real = float;
  typedef float Vector __attribute__((vector_size(16)));
  typedef float StoredVector __attribute__((vector_size(16), aligned(4), may_alias));
  static constexpr int Lanes = 4;
  typedef float PointVector __attribute__((vector_size(32)));
  static constexpr int Points = 8;
  static constexpr int ScaleBits = 40;
  static constexpr float ScaleUp = 0x1p40F;

  static PALPATE_INLINE Vector Spread(float value)
  {
    Vector result = value - Vector{};
    asm("" : "+x"(result));
    return result;
  }
};
} // namespace

const EvaluationKernels<double> Avx2Double = KernelsOf<Avx2DoubleSet>();
const EvaluationKernels<float> Avx2Float = KernelsOf<Avx2FloatSet>();
} // namespace palpate::evaluation
