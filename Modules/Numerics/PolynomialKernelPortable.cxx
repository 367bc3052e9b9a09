#include "PolynomialKernel.h"

namespace palpate::polynomial
{
struct PortableSet
{
  typedef double Vector __attribute__((vector_size(16), may_alias));
  static constexpr int Lanes = 2;
};
using PortableArithmetic = Arithmetic<PortableSet>;

const Kernel Portable{PortableSet::Lanes, PortableArithmetic::Radius, PortableArithmetic::Evaluate,
                      PortableArithmetic::EvaluateBatch};
} // namespace palpate::polynomial
