#include "PolynomialKernelChoice.h"

namespace palpate::polynomial
{
namespace
{
bool HasAvx2() noexcept
{
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}
} // namespace

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
} // namespace palpate::polynomial
