#pragma once

#include "MomentKernel.h"
#include "MomentTables.h"
#include "PackedTriangle.h"

namespace palpate
{
/// Assembles the Gram matrix sum_i w_i Y_j(u_i) Y_k(u_i), j, k < (L + 1)^2, from the moments of the
/// samples up to degree 2 L. With w = x + iy and s^2 = 1 - z^2, for orders m <= m',
///   2 Re w^m Re w^m' = Re w^(m+m') + s^(2m) Re w^(m'-m), and so on for the other three products,
/// so every entry is a sum of order m' + m and one of order m' - m, of polynomials in z that the
/// 2 L + 1 nodes of MomentTables integrate exactly. The polynomials are even or odd, so half the
/// nodes suffice.
class GramAssembly
{
public:
  GramAssembly(const MomentTables& tables, const moments::Kernel& kernel);

  /// `sums` are the moments (pairs, up to degree 2 L); the matrix is multiplied by `scale`.
  /// Does not allocate.
  void Assemble(const MomentTables& tables, const double* sums, double scale,
                PackedTriangle& gram) noexcept;

private:
  void FindNodeWeights(const MomentTables& tables, const double* sums, double scale) noexcept;
  const double* NodeWeights(const MomentTables& tables, int order, int parity,
                            int part) const noexcept;
  void FindPairWeights(const MomentTables& tables, int order, int otherOrder, int parity) noexcept;
  void Scatter(int order, int parity, int rows, int otherOrder, int otherParity, int otherRows,
               int columns, PackedTriangle& gram) const noexcept;

  const moments::Kernel* Kernel;
  CacheLineVector<double>
      Weights;                  // [order][parity][part][node]: measure at the nodes, times s^-order
  CacheLineVector<double> Pair; // [4][node]: of cosine cosine, sine sine, cosine sine, sine cosine
  CacheLineVector<double> Products;
};
} // namespace palpate
