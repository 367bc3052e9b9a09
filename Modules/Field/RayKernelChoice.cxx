#include "RayKernelChoice.h"

#include "BatchCast.h"

namespace palpate::rays
{
namespace
{
struct PortableSet
{
  typedef double Vector __attribute__((vector_size(16)));
  typedef int Integers __attribute__((vector_size(8)));
  static constexpr int Lanes = 2;
};
const Kernel Portable = {BatchCast<PortableSet>::Run};
} // namespace

const Kernel& KernelFor(InstructionSet set) noexcept
{
  return set == InstructionSet::Avx2 ? Avx2 : Portable;
}

int NumberOf(ScalarType type) noexcept
{
  return type == ScalarType::Float32 ? 4 : type == ScalarType::Float64 ? 5 : static_cast<int>(type);
}
} // namespace palpate::rays
