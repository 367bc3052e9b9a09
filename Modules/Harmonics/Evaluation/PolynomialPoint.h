#pragma once

#include "PolynomialTerms.h"
#include "SurfaceHessian.h"

// One direction by the polynomials of a PolynomialTable (the rule of Quartet.h applies here too).
// The degree is a template argument: every loop is unrolled, and terms that are always zero are
// omitted.

namespace palpate::evaluation
{
/// A unit vector and the arguments of the polynomials. The function is evaluated for the exactly
/// normalised direction: n = |u|^2 differs from 1 by rounding, and 1/n = 2 - n, 1/|u| = (3 - n) / 2
/// up to (n - 1)^2.
template <typename Set>
struct PolynomialDirection
{
  using Real = typename Set::Real;
  using Numbers = Quartet<Set>;

  explicit PALPATE_INLINE PolynomialDirection(const Real* direction)
  {
    const Numbers x = Numbers::All(direction[0]);
    const Numbers y = Numbers::All(direction[1]);
    const Numbers z = Numbers::All(direction[2]);
    const Numbers one = Numbers::All(1);
    const Numbers square = x * x + y * y;
    const Numbers excess = square + (z * z - one);
    const Numbers shrink = one - excess * Numbers::All(Real(0.5));
    this->T = (square + square) * excess + (one - square * Numbers::All(2));
    this->Excess = excess;
    this->Unit = {x * shrink, y * shrink, z * shrink};
  }

  UnitVector<Set> Unit;
  Numbers T;      // 1 - 2 (x^2 + y^2) / n
  Numbers Excess; // n - 1
};

/// R, and derivatives, of a model of degree `Degree` at one direction.
template <typename Set, int Degree>
struct PolynomialPoint
{
  using Real = typename Set::Real;
  using Numbers = Quartet<Set>;
  using Complexes = ComplexQuartet<Set>;
  using Direction = PolynomialDirection<Set>;

  // The layout of PolynomialTable: order 0, then blocks from order 1 on.
  static constexpr int ZonalCount = Degree / 4 + 1;
  static constexpr int EvenCount(int order) { return (Degree - order) / 2 + 1; }
  static constexpr int BlockStart(int order)
  {
    int start = 4 * ZonalCount;
    for (int first = 1; first < order; first += 4)
    {
      start += 8 * (Degree - first + 1);
    }
    return start;
  }
  static constexpr int HighestBlock = Degree == 0 ? 0 : 1 + (Degree - 1) / 4 * 4;

  template <int First, int Derivatives>
  static PALPATE_INLINE OrderTerms<Complexes> Block(const Real* table, const Direction& d)
  {
    const Real* even = table + BlockStart(First);
    const Real* odd = even + 8 * EvenCount(First);
    return PolynomialOrder<Complexes, Numbers, Degree - First, Derivatives>::Terms(even, odd, d.T,
                                                                                   d.Unit.Z);
  }

  // Blocks from the highest down to that of order 5: the highest have the shortest polynomials, so
  // no long chain remains once the last one is known.
  template <int First, int Derivatives>
  static PALPATE_INLINE OrderSums<Set, Derivatives>
  UpperBlock(const Real* table, const Direction& d, const Complexes* fourthPowers)
  {
    const Complexes& power = fourthPowers[First / 4];
    return {Block<First, Derivatives>(table, d),
            Numbers::Of(First, First + 1, First + 2, First + 3), power, power,
            WithFirstLane(fourthPowers[First / 4 - 1], power)};
  }
  template <int First, int Derivatives>
  static PALPATE_INLINE void AddUpperBlocks(const Real* table, const Direction& d,
                                            const Complexes* fourthPowers,
                                            OrderSums<Set, Derivatives>& sums)
  {
    if constexpr (First > 4)
    {
      sums.Add(UpperBlock<First, Derivatives>(table, d, fourthPowers));
      AddUpperBlocks<First - 4>(table, d, fourthPowers, sums);
    }
  }

  template <int Derivatives>
  static PALPATE_INLINE OrderSums<Set, Derivatives> AllBlocks(const Real* table, const Direction& d,
                                                              const LanePowers<Set>& powers)
  {
    const Numbers orders = Numbers::Of(1, 2, 3, 4);
    if constexpr (HighestBlock > 1)
    {
      Complexes fourthPowers[4];
      fourthPowers[0] = {Numbers::All(1), Numbers{}};
      fourthPowers[1] = {LastLane(powers.Value.Real), LastLane(powers.Value.Imaginary)};
      if constexpr (HighestBlock > 8)
      {
        fourthPowers[2] = Square(fourthPowers[1]);
      }
      if constexpr (HighestBlock > 12)
      {
        fourthPowers[3] = fourthPowers[2] * fourthPowers[1];
      }
      auto sums = UpperBlock<HighestBlock, Derivatives>(table, d, fourthPowers);
      AddUpperBlocks<HighestBlock - 4>(table, d, fourthPowers, sums);
      sums.Add({Block<1, Derivatives>(table, d), orders});
      return sums;
    }
    else if constexpr (HighestBlock > 0)
    {
      return {Block<1, Derivatives>(table, d), orders};
    }
    else
    {
      return OrderSums<Set, Derivatives>{};
    }
  }

  // Order 0, as four polynomials in t^2: E = E0(t^2) + t E1(t^2), and O likewise.
  template <int Derivatives>
  static PALPATE_INLINE ZonalTerms<Set> Zonal(const Real* table, const Direction& d)
  {
    const Numbers& t = d.T;
    const Numbers& z = d.Unit.Z;
    const Numbers zero{};
    const Numbers one = Numbers::All(1);
    const Numbers tt = t * t;
    Numbers p[3] = {Numbers::Load(table), zero, zero}; // and derivatives, the second halved
    for (int k = 1; k < ZonalCount; ++k)
    {
      if (Derivatives > 1 && k > 1)
      {
        p[2] = p[2] * tt + p[1];
      }
      if (Derivatives > 0)
      {
        p[1] = k > 1 ? p[1] * tt + p[0] : p[0];
      }
      p[0] = p[0] * tt + Numbers::Load(table + 4 * k);
    }
    const Numbers constant = p[0].UnlessFar(d.Excess);
    const Numbers powerOfT = Alternate(one, t);
    const Numbers powerOfZ = Halves(one, z);
    const Numbers value = constant * powerOfT;
    ZonalTerms<Set> terms;
    terms.Value = value * powerOfZ;
    if constexpr (Derivatives > 0)
    {
      const Numbers twiceT = t + t;
      const Numbers slope = p[1] * Alternate(twiceT, tt + tt) + Alternate(zero, constant);
      const Numbers fourZ = (z + z) + (z + z);
      terms.Slope = slope * (powerOfZ * fourZ) + Halves(zero, value);
      if constexpr (Derivatives > 1)
      {
        const Numbers sixT = twiceT + twiceT + twiceT;
        const Numbers second =
            p[1] * Alternate(one + one, sixT) + p[2] * (powerOfT * (twiceT * twiceT) * (one + one));
        const Numbers three = one + one + one;
        terms.Curvature = powerOfZ * (slope * Halves(one, three) + second * (z * fourZ));
      }
    }
    return terms;
  }

  static PALPATE_INLINE LanePowers<Set> Powers(const Direction& d)
  {
    LanePowers<Set> powers;
    powers.Value = FirstPowers(d.Unit.X, d.Unit.Y);
    powers.First = {Shifted(Numbers::All(1), powers.Value.Real),
                    Shifted(Numbers{}, powers.Value.Imaginary)};
    powers.Second = Rotated(powers.First);
    powers.FirstTimesW = powers.Value;
    return powers;
  }

  static Real Value(const Real* table, int, const Real* direction) noexcept
  {
    const Direction d(direction);
    const LanePowers<Set> powers = Powers(d);
    const auto zonal = Zonal<0>(table, d);
    return FinishValue(AllBlocks<0>(table, d, powers), powers, zonal);
  }
  static void Gradient(const Real* table, int, const Real* direction, Real* sample) noexcept
  {
    const Direction d(direction);
    const LanePowers<Set> powers = Powers(d);
    const auto zonal = Zonal<1>(table, d);
    FinishGradient(AllBlocks<1>(table, d, powers), powers, zonal, d.Unit, sample);
  }
  static void Hessian(const Real* table, int, const Real* direction, Real* sample) noexcept
  {
    const Direction d(direction);
    const LanePowers<Set> powers = Powers(d);
    const auto zonal = Zonal<2>(table, d);
    FinishHessian(AllBlocks<2>(table, d, powers), powers, zonal, d.Unit, Real(4), sample);
  }
};
} // namespace palpate::evaluation
