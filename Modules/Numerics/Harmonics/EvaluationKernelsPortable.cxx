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
template <typename Number, int Count>
struct PortableSet
{
  using Real = Number;
  typedef Number Vector __attribute__((vector_size(16)));
  typedef Number StoredVector __attribute__((vector_size(16), aligned(sizeof(Number)), may_alias));
  static constexpr int Lanes = Count;
  typedef Number PointVector __attribute__((vector_size(16)));
  static constexpr int Points = Count;
  static constexpr int ScaleBits = sizeof(Number) == sizeof(float) ? 40 : 256;
  static constexpr Number ScaleUp =
      sizeof(Number) == sizeof(float) ? Number(0x1p40) : Number(0x1p256);

  static PALPATE_INLINE Vector Spread(Number value) { return value - Vector{}; }
};
} // namespace

const EvaluationKernels<double> PortableDouble = KernelsOf<PortableSet<double, 2>>();
const EvaluationKernels<float> PortableFloat = KernelsOf<PortableSet<float, 4>>();
} // namespace palpate::evaluation
