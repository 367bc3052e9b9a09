#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace palpate
{
/// Allocates on cache lines, so that vectors of any width load without crossing one.
template <typename T>
struct CacheLineAllocator
{
  using value_type = T;
  static constexpr std::align_val_t Line{64};

  CacheLineAllocator() = default;
  template <typename U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>&) noexcept
  {
  }
  T* allocate(std::size_t count)
  {
    return static_cast<T*>(::operator new(count * sizeof(T), Line));
  }
  void deallocate(T* block, std::size_t) noexcept { ::operator delete(block, Line); }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
  friend bool operator!=(const CacheLineAllocator&, const CacheLineAllocator&) { return false; }
};

/// The coefficients of a radius function as polynomials, for the kernels that evaluate it.
///
/// With w = x + iy and t = 1 - 2 (x^2 + y^2) = 2 z^2 - 1 on the unit sphere,
///   R(u) = Re sum_m D_m(z) w^m,   D_m(z) = E_m(t) + z O_m(t),
/// where E_m and O_m have complex coefficients (cosine minus i sine terms) and at most half the
/// degree. t runs over [-1, 1], where these power sums are well conditioned: a term of degree n
/// grows by at most (1 + sqrt 2)^n. Good to about degree 16 in double.
///
/// Layout: first order 0, as pairs (E_0 coefficient, O_0 coefficient) from the highest power down,
/// `Order0Count` of them. Then blocks of `Lanes` consecutive orders, from order 1 on; in a block,
/// from the highest power down, `Lanes` cosine and `Lanes` sine coefficients of E, then the same of
/// O, with zeros for orders that have no such term or do not exist.
class PolynomialTable
{
public:
  PolynomialTable() = default;
  /// `coefficients` has (degree + 1)^2 entries in the convention of SphericalHarmonicBasis.
  PolynomialTable(int degree, const std::vector<double>& coefficients, int lanes);

  /// Powers in a block whose lowest order is `order` (E has this many coefficients).
  static constexpr int EvenCount(int degree, int order) { return (degree - order) / 2 + 1; }
  /// Coefficients of O in such a block; may be 0.
  static constexpr int OddCount(int degree, int order) { return (degree - order + 1) / 2; }

  int Degree() const noexcept { return this->MaximumDegree; }
  const double* Data() const noexcept { return this->Values.data(); }
  const double* End() const noexcept { return this->Values.data() + this->Values.size(); }
  std::size_t Bytes() const noexcept { return this->Values.size() * sizeof(double); }

private:
  int MaximumDegree = 0;
  std::vector<double, CacheLineAllocator<double>> Values;
};
} // namespace palpate
