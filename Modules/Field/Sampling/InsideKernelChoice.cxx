#include "InsideKernelChoice.h"

namespace palpate::inside
{
namespace
{
struct PortableSet
{
  typedef double Vector __attribute__((vector_size(16)));
  typedef int Integers __attribute__((vector_size(8)));
  static constexpr int Lanes = 2;
};
const Kernel Portable = Arithmetic<PortableSet>::All();
} // namespace

const Kernel& KernelFor(InstructionSet set) noexcept
{
  return set == InstructionSet::Avx2 ? Avx2 : Portable;
}
} // namespace palpate::inside
