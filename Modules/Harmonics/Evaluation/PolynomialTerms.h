#pragma once

#include "OrderSums.h"

// Evaluation of one order, or one block of orders, by polynomials (the rule of Quartet.h applies
// here too). `Numbers` are the lanes, `Complex` several of them, with Load for coefficients that
// take `Size` numbers of a table.

namespace palpate::evaluation
{
/// Horner's rule for a polynomial in t with `Count` complex coefficients, from the highest power
/// down, and for its derivatives in t.
template <typename Complex, typename Numbers, int Count, int Derivatives>
struct HornerPolynomial
{
  template <typename Real>
  PALPATE_INLINE HornerPolynomial(const Real* table, const Numbers& t)
  {
    this->template Step<0>(table, t);
  }

  template <int Power, typename Real>
  PALPATE_INLINE void Step(const Real* table, const Numbers& t)
  {
    if constexpr (Power < Count)
    {
      const Complex next = Complex::Load(table);
      if constexpr (Derivatives > 1 && Power > 1)
      {
        Raise<(Power > 2)>(this->HalfCurvature, t, this->Slope);
      }
      if constexpr (Derivatives > 0 && Power > 0)
      {
        Raise<(Power > 1)>(this->Slope, t, this->Value);
      }
      Raise<(Power > 0)>(this->Value, t, next);
      this->template Step<Power + 1>(table + Complex::Size, t);
    }
  }
  // The first step only initialises a polynomial.
  template <bool Started>
  static PALPATE_INLINE void Raise(Complex& polynomial, const Numbers& t, const Complex& next)
  {
    if constexpr (Started)
    {
      polynomial = t * polynomial + next;
    }
    else
    {
      polynomial = next;
    }
  }

  Complex Value;
  Complex Slope;         // if Derivatives > 0 and Count > 1
  Complex HalfCurvature; // if Derivatives > 1 and Count > 2
};

/// D = E(t) + z O(t) of an order that is `Above` below the degree, and its derivatives in z.
template <typename Complex, typename Numbers, int Above, int Derivatives>
struct PolynomialOrder
{
  static constexpr int EvenCount = Above / 2 + 1;
  static constexpr int OddCount = (Above + 1) / 2;
  using Even = HornerPolynomial<Complex, Numbers, EvenCount, Derivatives>;
  using Odd = HornerPolynomial<Complex, Numbers, OddCount, Derivatives>;

  /// `even` and `odd` point to the first coefficients.
  template <typename Real>
  static PALPATE_INLINE OrderTerms<Complex> Terms(const Real* even, const Real* odd,
                                                  const Numbers& t, const Numbers& z)
  {
    const Even e(even, t);
    const Odd o(odd, t);
    OrderTerms<Complex> terms;
    terms.Value = Both<(OddCount > 0)>(e.Value, o.Value, z);
    if constexpr (Derivatives > 0)
    {
      terms.Slope = Slope(e, o, z);
    }
    if constexpr (Derivatives > 1)
    {
      terms.Curvature = QuarterCurvature(e, o, z);
    }
    return terms;
  }

  // E + z O, without O if it does not exist.
  template <bool WithOdd>
  static PALPATE_INLINE Complex Both(const Complex& even, const Complex& odd, const Numbers& z)
  {
    if constexpr (WithOdd)
    {
      return z * odd + even;
    }
    else
    {
      return even;
    }
  }
  // dD/dz = O + 4 z (E' + z O').
  static PALPATE_INLINE Complex Slope(const Even& e, const Odd& o, const Numbers& z)
  {
    if constexpr (EvenCount > 1)
    {
      const Numbers fourZ = (z + z) + (z + z);
      return fourZ * Both<(OddCount > 1)>(e.Slope, o.Slope, z) + o.Value;
    }
    else if constexpr (OddCount > 0)
    {
      return o.Value;
    }
    else
    {
      return Complex::Zero();
    }
  }
  // A quarter of d2D/dz2 = 4 (E' + 3 z O') + 16 z^2 (E'' + z O'').
  static PALPATE_INLINE Complex QuarterCurvature(const Even& e, const Odd& o, const Numbers& z)
  {
    if constexpr (EvenCount > 2)
    {
      const Numbers eightSquares = (z + z) * ((z + z) + (z + z));
      return eightSquares * Both<(OddCount > 2)>(e.HalfCurvature, o.HalfCurvature, z) +
             Both<(OddCount > 1)>(e.Slope, o.Slope, z + z + z);
    }
    else if constexpr (EvenCount > 1)
    {
      return Both<(OddCount > 1)>(e.Slope, o.Slope, z + z + z);
    }
    else
    {
      return Complex::Zero();
    }
  }
};
} // namespace palpate::evaluation
