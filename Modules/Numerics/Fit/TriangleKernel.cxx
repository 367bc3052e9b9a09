// The arithmetic for AVX2 and FMA: this file alone is compiled for them (see CMakeLists.txt), so it
// must include nothing else. The portable arithmetic is made in TriangleKernelChoice.cxx.
#include "TriangleKernel.h"

namespace palpate::triangle
{
struct Avx2Set
{
  typedef double Vector __attribute__((vector_size(32), may_alias));
  static constexpr int Lanes = 4;
};
using Avx2Arithmetic = Arithmetic<Avx2Set>;

const Kernel Avx2{Avx2Set::Lanes,
                  Avx2Arithmetic::Factorise,
                  Avx2Arithmetic::SolveLower,
                  Avx2Arithmetic::SolveUpper,
                  Avx2Arithmetic::MultiplyLower,
                  Avx2Arithmetic::MultiplyUpper};
} // namespace palpate::triangle
