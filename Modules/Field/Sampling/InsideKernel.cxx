// The inside test for AVX2: only this file is compiled for it (see CMakeLists.txt), so it must
// include nothing else. The portable version is in FieldSampler.cxx.
#include "InsideKernel.h"

namespace palpate::inside
{
struct Avx2Set
{
  typedef double Vector __attribute__((vector_size(32)));
  typedef int Integers __attribute__((vector_size(16)));
  static constexpr int Lanes = 4;
};

const Kernel Avx2 = Arithmetic<Avx2Set>::All();
} // namespace palpate::inside
