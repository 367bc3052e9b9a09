#include "NearestKernelChoice.h"

namespace palpate::nearest
{
namespace
{
struct PortableSet
{
  typedef double Vector __attribute__((vector_size(16)));
  typedef long long Integers __attribute__((vector_size(16)));
  static constexpr int Lanes = 2;

  static inline __attribute__((always_inline)) bool Any(const Integers& lanes)
  {
    return (lanes[0] | lanes[1]) != 0;
  }
};

const Kernel Portable{Arithmetic<PortableSet>::Find};
} // namespace

const Kernel& KernelFor(InstructionSet set) noexcept
{
  return set == InstructionSet::Avx2 ? Avx2 : Portable;
}
} // namespace palpate::nearest
