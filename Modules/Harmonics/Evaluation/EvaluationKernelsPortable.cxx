#include "EvaluationKernelsPortable.h"

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
struct PortableSet
{
  using Real = double;
  typedef double Vector __attribute__((vector_size(16)));
  typedef double StoredVector __attribute__((vector_size(16), aligned(8), may_alias));
  static constexpr int Lanes = 2;
  typedef double PointVector __attribute__((vector_size(16)));
  static constexpr int Points = 2;
  // 2^256
  static constexpr int ScaleBits = 256;
  static constexpr double ScaleUp = 0x1p256;

  static PALPATE_INLINE Vector Spread(double value) { return value - Vector{}; }
};
} // namespace

const EvaluationKernels Portable = KernelsOf<PortableSet>();
} // namespace palpate::evaluation
