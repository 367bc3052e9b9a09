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

bool HasAvx2() noexcept
{
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}
} // namespace

const Kernel Portable{PortableSet::Lanes, PortableArithmetic::Accumulate,
                      PortableArithmetic::Residuals, PortableArithmetic::WeightedProducts};

const Kernel& FastestKernel() noexcept
{
  static const bool avx2 = HasAvx2();
  return avx2 ? Avx2 : Portable;
}

std::vector<NamedKernel> RunnableKernels()
{
  std::vector<NamedKernel> kernels{{"portable", &Portable}};
  if (HasAvx2())
  {
    kernels.push_back({"avx2", &Avx2});
  }
  return kernels;
}
} // namespace palpate::moments
