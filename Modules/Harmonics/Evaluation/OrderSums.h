#pragma once

#include "Quartet.h"

// Shared by both formulations at one direction (the rule of Quartet.h applies here too). With
// w = x + iy a radius function is R = Re sum_m conj(D_m(z)) w^m, and its spatial derivatives follow
// from those of D_m in z and of w^m. Orders are grouped in blocks of four. The lane-dependent part
// of the powers of w is applied once, at the end (LanePowers); a block only adds the power of w^4
// by which it exceeds the lowest block.

namespace palpate::evaluation
{
/// w, w^2, w^3, w^4.
template <typename Set>
PALPATE_INLINE ComplexQuartet<Set> FirstPowers(const Quartet<Set>& x, const Quartet<Set>& y)
{
  const ComplexQuartet<Set> square{x * x - y * y, (x + x) * y};
  const ComplexQuartet<Set> low{Alternate(x, square.Real), Alternate(y, square.Imaginary)};
  const ComplexQuartet<Set> high{Halves(Quartet<Set>::All(1), square.Real),
                                 Halves(Quartet<Set>{}, square.Imaginary)};
  return low * high;
}

/// w^m, w^(m-1) and w^(m-2) for the lanes of the lowest block. A lane whose power would be negative
/// holds the power of the next block instead; its terms in the lowest block are zero.
template <typename Set>
struct LanePowers
{
  ComplexQuartet<Set> Value;  // w^m
  ComplexQuartet<Set> First;  // w^(m-1)
  ComplexQuartet<Set> Second; // w^(m-2)
  ComplexQuartet<Set> FirstTimesW;
};

/// D_m and its derivatives in z for the orders of a block. The second derivative may be scaled by
/// any fixed factor.
template <typename Complex>
struct OrderTerms
{
  Complex Value;
  Complex Slope;
  Complex Curvature;
};

/// Sums over the blocks of the terms of R and its derivatives.
template <typename Set, int Derivatives>
struct OrderSums
{
  using Terms = OrderTerms<ComplexQuartet<Set>>;
  using Numbers = Quartet<Set>;
  using Complexes = ComplexQuartet<Set>;

  OrderSums() = default;
  /// Starts with the lowest block.
  PALPATE_INLINE OrderSums(const Terms& terms, const Numbers& orders)
  {
    this->Value = terms.Value;
    if constexpr (Derivatives > 0)
    {
      this->First = orders * terms.Value;
      this->Slope = terms.Slope;
    }
    if constexpr (Derivatives > 1)
    {
      this->Second = orders * (orders - Numbers::All(1)) * terms.Value;
      this->FirstSlope = orders * terms.Slope;
      this->Curvature = terms.Curvature;
    }
  }
  /// Adds a block, with its powers of w^4: one for each of LanePowers.
  PALPATE_INLINE OrderSums(const Terms& terms, const Numbers& orders, const Complexes& value,
                           const Complexes& first, const Complexes& second)
  {
    this->Value = Turned(terms.Value, value);
    if constexpr (Derivatives > 0)
    {
      this->First = orders * Turned(terms.Value, first);
      this->Slope = Turned(terms.Slope, value);
    }
    if constexpr (Derivatives > 1)
    {
      this->Second = orders * (orders - Numbers::All(1)) * Turned(terms.Value, second);
      this->FirstSlope = orders * Turned(terms.Slope, first);
      this->Curvature = Turned(terms.Curvature, value);
    }
  }
  PALPATE_INLINE void Add(const OrderSums& block)
  {
    this->Value = this->Value + block.Value;
    if constexpr (Derivatives > 0)
    {
      this->First = this->First + block.First;
      this->Slope = this->Slope + block.Slope;
    }
    if constexpr (Derivatives > 1)
    {
      this->Second = this->Second + block.Second;
      this->FirstSlope = this->FirstSlope + block.FirstSlope;
      this->Curvature = this->Curvature + block.Curvature;
    }
  }

  Complexes Value;      // D
  Complexes First;      // m D
  Complexes Second;     // m (m-1) D
  Complexes Slope;      // dD/dz
  Complexes FirstSlope; // m dD/dz
  Complexes Curvature;  // d2D/dz2
};

/// A unit vector, each coordinate in all lanes.
template <typename Set>
struct UnitVector
{
  Quartet<Set> X;
  Quartet<Set> Y;
  Quartet<Set> Z;
};

/// Contributions of terms outside the blocks to R, dR/dz and d2R/dz2, distributed over the lanes in
/// any way.
template <typename Set>
struct ZonalTerms
{
  Quartet<Set> Value{};
  Quartet<Set> Slope{};
  Quartet<Set> Curvature{};
};

template <typename Set>
PALPATE_INLINE typename Set::Real FinishValue(const OrderSums<Set, 0>& sums,
                                              const LanePowers<Set>& powers,
                                              const ZonalTerms<Set>& zonal)
{
  return AddTerms(zonal.Value, sums.Value, powers.Value).Sum();
}

/// Writes R and the tangential part of its gradient at u.
template <typename Set>
PALPATE_INLINE void FinishGradient(const OrderSums<Set, 1>& sums, const LanePowers<Set>& powers,
                                   const ZonalTerms<Set>& zonal, const UnitVector<Set>& u,
                                   typename Set::Real* sample)
{
  const Quartet<Set> value = AddTerms(zonal.Value, sums.Value, powers.Value);
  const ComplexQuartet<Set> plane = Turned(sums.First, powers.First);
  const Quartet<Set> alongZ = AddTerms(zonal.Slope, sums.Slope, powers.Value);
  // x and y times the derivatives along them: m Re(conj(D) w^m).
  const Quartet<Set> radial = alongZ * u.Z + Terms(sums.First, powers.FirstTimesW);
  Sums(value, plane.Real - radial * u.X, plane.Imaginary - radial * u.Y, alongZ - radial * u.Z)
      .Store(sample);
}
} // namespace palpate::evaluation
