#include "MomentKernelChoice.h"

namespace palpate::moments
{
namespace
{
struct PortableSet
{
  typedef double Vector __attribute__((vector_size(16), may_alias));
  static constexpr int Lanes = 2;
};
using PortableArithmetic = Arithmetic<PortableSet>;
} // namespace

const Kernel Portable{PortableSet::Lanes, PortableArithmetic::Accumulate,
                      PortableArithmetic::Residuals, PortableArithmetic::WeightedProducts};

const Kernel& KernelFor(InstructionSet set) noexcept
{
  return set == InstructionSet::Avx2 ? Avx2 : Portable;
}
} // namespace palpate::moments
