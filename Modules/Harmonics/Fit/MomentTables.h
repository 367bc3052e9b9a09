#pragma once

#include "CacheLineVector.h"
#include "MomentKernel.h"
#include "SphericalHarmonicRecurrence.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Constants that convert moments of a sample set to the normal equations of a fit.
///
/// A moment of order m and column k is sum_i w_i (x_i + i y_i)^m p_k(z_i). Four consecutive orders
/// share the polynomials p_k of the first of them: p_k is Q_(m0+k)m0 of
/// SphericalHarmonicRecurrence, scaled so that its leading coefficient is 2^k. So a moment takes
/// two products per point once the p_k are known (26 of 49 columns at degree 12), and yet p_k is
/// nearly orthogonal for the weight s^(2m), s^2 = 1 - z^2, at every degree; one family for all
/// orders would lose the digits that s^(-2m) has near the poles.
///
/// The harmonics of order m are combinations of p_0 .. p_(L-m) (ToHarmonics, FromHarmonics). Sums
/// of products of two harmonics up to degree L need only the moments m + k <= 2L; node weights turn
/// those into sums over the 2L + 1 Gauss-Legendre nodes (see GramAssembly), exactly.
class MomentTables
{
public:
  /// For fits of `degree` >= 0; rows of the tables are padded for `lanes` numbers at once.
  MomentTables(int degree, int lanes);

  int Degree() const noexcept { return this->MaximumDegree; }
  moments::Recurrence FamilyRecurrence() const noexcept
  {
    return {this->Factors.data(), 2 * this->MaximumDegree + 1};
  }

  /// Coefficients (degree + 1)^2 of a model as pairs in the order of the moments.
  void FromHarmonics(const double* coefficients, double* pairs) const noexcept;
  /// The transpose: from moments up to the degree to sums with the harmonics.
  void ToHarmonics(const double* pairs, double* sums) const noexcept;

  /// Nodes z >= 0 of the quadrature.
  int Nodes() const noexcept { return this->MaximumDegree + 1; }
  /// Nodes() rounded up to the lanes: the length of rows of node values.
  int NodeStride() const noexcept { return this->Stride; }
  /// Contribution of a moment to the measure at each node, over s^m0: sum_mk moment_mk
  /// NodeValues(m, k) s^(m0 - m) is s^-m times the measure of order m.
  const double* NodeValues(int order, int column) const noexcept;
  /// s^(m0 - m) for m - m0 = 0 .. OrdersPerFamily - 1, one number per node.
  const double* InversePowers(int orderInFamily) const noexcept
  {
    return this->Powers.data() + orderInFamily * this->Stride;
  }

  /// Q_lm(z) s^m of one order, for degrees l = m + parity, m + parity + 2, ...
  struct Block
  {
    int Rows;             ///< number of degrees
    int Columns;          ///< Rows rounded up to the lanes
    const double* ByRow;  ///< [Rows][NodeStride()]
    const double* ByNode; ///< [Nodes()][Columns]
  };
  Block HarmonicsAtNodes(int order, int parity) const noexcept;

private:
  void MakeFactors(const SphericalHarmonicRecurrence& harmonics);
  void MakeConversions(const SphericalHarmonicRecurrence& harmonics);
  void MakeNodes();
  void MakeFamilyValues(const SphericalHarmonicRecurrence& harmonics);
  void MakeBlocks(const SphericalHarmonicRecurrence& harmonics, int lanes);

  int MaximumDegree;
  int Stride;
  std::vector<double> NodeZ;
  std::vector<double> NodeWeights; // doubled where z > 0, for the node at -z
  std::vector<double> Factors;
  CacheLineVector<double> FamilyValues;
  std::vector<std::size_t> FamilyStarts;
  CacheLineVector<double> Powers;
  std::vector<double> Conversions; // order by order, degree by degree: columns 0 .. l - m
  CacheLineVector<double> BlockValues;
  struct BlockPlace
  {
    int Rows;
    int Columns;
    std::size_t ByRow;
    std::size_t ByNode;
  };
  std::vector<BlockPlace> Blocks;
};
} // namespace palpate
