#include "HouseholderReduction.h"

#include "HouseholderReductionAvx2.h"

#include <Eigen/QR>

namespace palpate::householder
{
namespace
{
void ReducePortably(double* matrix, std::ptrdiff_t rows, std::ptrdiff_t columns, double* right)
{
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;
  Eigen::Map<Matrix> values(matrix, rows, columns);
  const Eigen::HouseholderQR<Eigen::Ref<Matrix>> qr(values);
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 1>>(right, rows)
      .applyOnTheLeft(qr.householderQ().adjoint());
}
} // namespace

Reduction ReductionFor(InstructionSet set) noexcept
{
  return set == InstructionSet::Avx2 ? ReduceByAvx2 : ReducePortably;
}
} // namespace palpate::householder
