// The ray kernel for AVX2: only this file is compiled for it (see CMakeLists.txt), so it must
// include nothing else.
#include "BatchCast.h"

namespace palpate::rays
{
struct Avx2Set
{
  typedef double Vector __attribute__((vector_size(32)));
  typedef int Integers __attribute__((vector_size(16)));
};

void CastAvx2(const Field& field, int count, Batch& batch)
{
  BatchCast<Avx2Set>::Run(field, count, batch);
}
} // namespace palpate::rays
