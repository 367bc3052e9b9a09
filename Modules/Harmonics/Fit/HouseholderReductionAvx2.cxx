// HouseholderReduction.cxx compiled for AVX2 and FMA (see CMakeLists.txt). Eigen's namespace is
// renamed here, so that no function compiled for AVX2 is linked into code for older processors; a
// test checks this object's symbols (Structure.Avx2Symbols).
#define Eigen EigenForAvx2

#include "HouseholderReductionAvx2.h"

#include <Eigen/QR>

namespace palpate::householder
{
void ReduceByAvx2(double* matrix, std::ptrdiff_t rows, std::ptrdiff_t columns, double* right)
{
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;
  Eigen::Map<Matrix> values(matrix, rows, columns);
  const Eigen::HouseholderQR<Eigen::Ref<Matrix>> qr(values);
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 1>>(right, rows)
      .applyOnTheLeft(qr.householderQ().adjoint());
}
} // namespace palpate::householder
