#pragma once

#include <cstddef>

namespace palpate::bench
{
/// What Eigen's own templates make of the jobs of our fits, compiled for one instruction set: a
/// library for each (CMakeLists.txt), whose inline functions stay in it. Matrices are column by
/// column.
class EigenPeers
{
public:
  virtual ~EigenPeers() = default;

  /// solution = the least squares' one, by LLT of the normal equations.
  virtual void NormalEquations(const double* design, std::ptrdiff_t rows, std::ptrdiff_t columns,
                               const double* right, double* solution) const = 0;
  /// The same by HouseholderQR, and by ColPivHouseholderQR.
  virtual void Householder(const double* design, std::ptrdiff_t rows, std::ptrdiff_t columns,
                           const double* right, double* solution) const = 0;
  virtual void PivotedHouseholder(const double* design, std::ptrdiff_t rows, std::ptrdiff_t columns,
                                  const double* right, double* solution) const = 0;
};

/// For the fastest instruction set that this processor has, as ours.
const EigenPeers& FastestEigenPeers();
const EigenPeers& PortableEigenPeers();
} // namespace palpate::bench
