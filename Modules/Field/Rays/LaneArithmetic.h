#pragma once

#include "RayKernel.h"

// Compiled for AVX2 alone: see RayKernel.h.

namespace palpate::rays
{
/// Vector operations of the kernel. `Set` describes an instruction set: `Vector` and `Integers`,
/// vectors of four doubles and ints (GCC and Clang's vector extension). Least and Largest treat NaN
/// and equal values as std::min and std::max do.
template <typename Set>
struct LaneArithmetic
{
  using Vector = typename Set::Vector;
  using Integers = typename Set::Integers;
  using Mask = decltype(Vector{} < Vector{});
  static constexpr int Lanes = rays::Lanes;

  /// function(lane) for every lane, as a vector.
  template <typename Result, typename Function>
  static inline __attribute__((always_inline)) Result Each(const Function& function)
  {
    return Result{function(0), function(1), function(2), function(3)};
  }
  static inline __attribute__((always_inline)) Vector All(double value) { return Vector{} + value; }
  static inline __attribute__((always_inline)) Vector Least(const Vector& a, const Vector& b)
  {
    return b < a ? b : a;
  }
  static inline __attribute__((always_inline)) Vector Largest(const Vector& a, const Vector& b)
  {
    return a < b ? b : a;
  }
  static inline __attribute__((always_inline)) Vector Absolute(const Vector& a)
  {
    return (Vector)((Mask)a & 0x7FFFFFFFFFFFFFFFLL);
  }
  /// a where the mask is set, else 0.
  static inline __attribute__((always_inline)) Vector Where(const Mask& mask, const Vector& a)
  {
    return (Vector)((Mask)a & mask);
  }
  static inline __attribute__((always_inline)) Vector Mean(const Vector& a, const Vector& b,
                                                           const Vector& u)
  {
    return a * (1.0 - u) + b * u;
  }
  static inline __attribute__((always_inline)) Vector Real(const Integers& a)
  {
    // GCC 12 emits four instructions for __builtin_convertvector and one for this.
    return Each<Vector>([&a](int lane) { return static_cast<double>(a[lane]); });
  }
  /// The nearest whole number; magnitude below 2^51.
  static inline __attribute__((always_inline)) Vector Nearest(const Vector& a)
  {
    constexpr double Shift = 6755399441055744.0; // 1.5 2^52
    return a + Shift - Shift;
  }
  /// The largest multiple of a power of two that is not above a, which must be whole.
  template <int Power>
  static inline __attribute__((always_inline)) Vector FloorOf(const Vector& a)
  {
    constexpr double Shift = Power * 6755399441055744.0;
    constexpr double Half = 0.5 * (Power - 1);
    return a - Half + Shift - Shift;
  }
  /// Whole numbers from 0 to below 2^52.
  static inline __attribute__((always_inline)) Mask Whole(const Vector& a)
  {
    constexpr double Shift = 4503599627370496.0; // 2^52
    return (Mask)(a + Shift) & 0xFFFFFFFFFFFFFLL;
  }
  static inline __attribute__((always_inline)) Vector OfWhole(const Mask& a)
  {
    constexpr double Shift = 4503599627370496.0;
    return (Vector)(a | (Mask)(Vector{} + Shift)) - Shift;
  }
  /// Whether any lane is set.
  static inline __attribute__((always_inline)) bool IsAny(const Mask& mask)
  {
    typedef long long Half __attribute__((vector_size(16)));
    const Half all = Half{mask[0], mask[1]} | Half{mask[2], mask[3]};
    return (all[0] | all[1]) != 0;
  }
};
} // namespace palpate::rays
