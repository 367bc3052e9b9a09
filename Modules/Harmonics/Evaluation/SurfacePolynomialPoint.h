#pragma once

#include "EvaluationKernel.h"
#include "PolynomialPoint.h"
#include "SurfaceSums.h"

// A surface at one direction by the polynomials of a SurfacePolynomialTable (the rule of Quartet.h
// applies here too). Lanes are the cosine and sine terms of two consecutive orders. The three
// coordinates share the powers of w, and their polynomials hide each other's latency.

namespace palpate::evaluation
{
/// Four numbers for each of `Axes` coordinates, in rows of a table that have them for all three.
template <typename Set, int Axes>
struct CoordinateQuartets
{
  using Numbers = Quartet<Set>;
  static constexpr int Size = 12; // numbers of a row

  static PALPATE_INLINE CoordinateQuartets Zero()
  {
    return Each([](int) { return Numbers{}; });
  }
  static PALPATE_INLINE CoordinateQuartets Load(const typename Set::Real* values)
  {
    return Each([values](int axis) { return Numbers::Load(values + 4 * axis); });
  }
  PALPATE_INLINE void Store(typename Set::Real* values) const
  {
    for (int axis = 0; axis < Axes; ++axis)
    {
      this->Axis[axis].Store(values + 4 * axis);
    }
  }
  template <typename Of>
  static PALPATE_INLINE CoordinateQuartets Each(const Of& of)
  {
    CoordinateQuartets result;
    for (int axis = 0; axis < Axes; ++axis)
    {
      result.Axis[axis] = of(axis);
    }
    return result;
  }

  Numbers Axis[Axes];
};

template <typename Set, int Axes>
PALPATE_INLINE CoordinateQuartets<Set, Axes> operator+(const CoordinateQuartets<Set, Axes>& a,
                                                       const CoordinateQuartets<Set, Axes>& b)
{
  return CoordinateQuartets<Set, Axes>::Each([&](int axis) { return a.Axis[axis] + b.Axis[axis]; });
}

template <typename Set, int Axes>
PALPATE_INLINE CoordinateQuartets<Set, Axes> operator*(const Quartet<Set>& a,
                                                       const CoordinateQuartets<Set, Axes>& b)
{
  return CoordinateQuartets<Set, Axes>::Each([&](int axis) { return a * b.Axis[axis]; });
}

/// The powers of w of each pair of orders (m, m + 1), interleaved: w^m; then m w^(m-1) and
/// m (m - 1) w^(m-2), each followed by itself divided by i.
template <typename Set, int Derivatives>
struct PairPowers
{
  using Real = typename Set::Real;
  using Numbers = Quartet<Set>;
  static constexpr int Size = 4 * (2 * Derivatives + 1); // numbers of a pair

  PALPATE_INLINE PairPowers(const UnitVector<Set>& u, int pairs)
  {
    const Numbers signs = Numbers::Of(-1, 1, -1, 1);
    const Numbers real = u.X * u.X - u.Y * u.Y;
    const Numbers imaginary = (u.X + u.X) * u.Y * signs;
    const auto timesSquare = [&](const Numbers& a) { return a * real + Exchanged(a) * imaginary; };
    Numbers second = Numbers::Of(0, 0, 1, 0); // the first has the factor 0
    Numbers power = Halves(Alternate(u.X, u.Y), timesSquare(second));
    Numbers orders = Numbers::Of(1, 1, 2, 2);
    Real* next = this->Factors;
    for (int pair = 0; pair < pairs; ++pair, next += Size)
    {
      power.Store(next);
      if constexpr (Derivatives > 0)
      {
        const Numbers first = orders * Joined(second, power);
        first.Store(next + 4);
        (signs * Exchanged(first)).Store(next + 8);
      }
      if constexpr (Derivatives > 1)
      {
        const Numbers weighted = orders * (orders - Numbers::All(1)) * second;
        weighted.Store(next + 12);
        (signs * Exchanged(weighted)).Store(next + 16);
      }
      second = power;
      power = timesSquare(power);
      orders = orders + Numbers::All(2);
    }
  }

  alignas(64) Real Factors[Size * HighestSurfacePolynomialDegree / 2];
};

/// E or O of order 0, lanes are x, y, z, and its derivatives in t.
template <typename Set, int Derivatives>
struct ZonalPolynomial
{
  using Numbers = Quartet<Set>;

  PALPATE_INLINE void Step(const Numbers& t, const Numbers& next)
  {
    if constexpr (Derivatives > 1)
    {
      this->HalfCurvature = t * this->HalfCurvature + this->Slope;
    }
    if constexpr (Derivatives > 0)
    {
      this->Slope = t * this->Slope + this->Value;
    }
    this->Value = t * this->Value + next;
  }

  Numbers Value{};
  Numbers Slope{};
  Numbers HalfCurvature{};
};

template <typename Set, int Derivatives>
struct SurfacePolynomialPoint
{
  using Real = typename Set::Real;
  using Numbers = Quartet<Set>;
  // Coordinates whose polynomials are evaluated side by side: as many as fit into the registers.
  static constexpr int AxesAtOnce = Numbers::Parts == 1 ? 3 : 1;
  using Row = CoordinateQuartets<Set, AxesAtOnce>;
  using Direction = PolynomialDirection<Set>;
  using Powers = PairPowers<Set, Derivatives>;
  using Space = SpaceDerivatives<Set, Numbers>;

  static constexpr int HighestPairs = HighestSurfacePolynomialDegree / 2;
  static constexpr int TermSize = Row::Size * (Derivatives + 1); // numbers of a pair

  // D of every pair and its derivatives in z, from the highest pair down: the one with `Count` even
  // powers, then the others. So one piece of code, unrolled, serves every degree.
  template <int Count>
  static PALPATE_INLINE void StoreTerms(const Real* table, int pairs, const Direction& d,
                                        Real* terms)
  {
    if constexpr (Count <= HighestPairs)
    {
      if (Count <= pairs)
      {
        using Order = PolynomialOrder<Row, Numbers, 2 * Count - 1, Derivatives>;
        const auto sums = Order::Terms(table, table + Row::Size * Count, d.T, d.Unit.Z);
        sums.Value.Store(terms);
        if constexpr (Derivatives > 0)
        {
          sums.Slope.Store(terms + Row::Size);
        }
        if constexpr (Derivatives > 1)
        {
          sums.Curvature.Store(terms + 2 * Row::Size);
        }
        StoreTerms<Count + 1>(table + 2 * Row::Size * Count, pairs, d, terms + TermSize);
      }
    }
  }

  // Products of one coordinate's terms with the powers, summed over the pairs.
  struct PairSums
  {
    PALPATE_INLINE PairSums(const Powers& powers, int pairs, const Real* terms)
    {
      const Real* factors = powers.Factors + Powers::Size * (pairs - 1);
      for (int pair = 0; pair < pairs; ++pair, factors -= Powers::Size, terms += TermSize)
      {
        const Numbers value = Numbers::Load(terms);
        const Numbers power = Numbers::Load(factors);
        this->Value = this->Value + value * power;
        if constexpr (Derivatives > 0)
        {
          const Numbers slope = Numbers::Load(terms + Row::Size);
          const Numbers first = Numbers::Load(factors + 4);
          const Numbers turned = Numbers::Load(factors + 8);
          this->Space.X = this->Space.X + value * first;
          this->Space.Y = this->Space.Y + value * turned;
          this->Space.Z = this->Space.Z + slope * power;
          if constexpr (Derivatives > 1)
          {
            this->Space.XX = this->Space.XX + value * Numbers::Load(factors + 12);
            this->Space.XY = this->Space.XY + value * Numbers::Load(factors + 16);
            this->Space.XZ = this->Space.XZ + slope * first;
            this->Space.YZ = this->Space.YZ + slope * turned;
            this->Space.ZZ = this->Space.ZZ + Numbers::Load(terms + 2 * Row::Size) * power;
          }
        }
      }
    }

    Numbers Value{};
    SpaceDerivatives<Set, Numbers> Space{};
  };

  // Lanes become coordinates.
  static PALPATE_INLINE SurfaceSums<Set> Together(const PairSums& x, const PairSums& y,
                                                  const PairSums& z)
  {
    const auto sums = [&](Numbers Space::*part)
    { return Sums(x.Space.*part, y.Space.*part, z.Space.*part, Numbers{}); };
    SurfaceSums<Set> s;
    s.Value = Sums(x.Value, y.Value, z.Value, Numbers{});
    if constexpr (Derivatives > 0)
    {
      s.Space.X = sums(&Space::X);
      s.Space.Y = sums(&Space::Y);
      s.Space.Z = sums(&Space::Z);
    }
    if constexpr (Derivatives > 1)
    {
      s.Space.XX = sums(&Space::XX);
      s.Space.XY = sums(&Space::XY);
      s.Space.XZ = sums(&Space::XZ);
      s.Space.YZ = sums(&Space::YZ);
      s.Space.ZZ = sums(&Space::ZZ);
    }
    return s;
  }

  // Adds order 0; the formulas of PolynomialOrder. The second derivative is still a quarter.
  static PALPATE_INLINE void AddZonal(const Real* table, int pairs, const Direction& d,
                                      SurfaceSums<Set>& s)
  {
    ZonalPolynomial<Set, Derivatives> even;
    ZonalPolynomial<Set, Derivatives> odd;
    for (int power = 0; power <= pairs; ++power, table += 8)
    {
      even.Step(d.T, Numbers::Load(table));
      odd.Step(d.T, Numbers::Load(table + 4));
    }
    const Numbers& z = d.Unit.Z;
    const Numbers twoZ = z + z;
    const Numbers fourZ = twoZ + twoZ;
    s.Value = s.Value + even.Value + z * odd.Value;
    if constexpr (Derivatives > 0)
    {
      const Numbers slope = even.Slope + z * odd.Slope;
      s.Space.Z = s.Space.Z + odd.Value + fourZ * slope;
      if constexpr (Derivatives > 1)
      {
        const Numbers curvature = even.HalfCurvature + z * odd.HalfCurvature;
        s.Space.ZZ =
            Numbers::All(4) * (s.Space.ZZ + slope + twoZ * odd.Slope + twoZ * fourZ * curvature);
      }
    }
  }

  static PALPATE_INLINE SurfaceSums<Set> AllSums(const Real* table, int degree, const Direction& d)
  {
    const int pairs = degree / 2;
    const Powers powers(d.Unit, pairs);
    alignas(64) Real terms[TermSize * HighestPairs];
    for (int axis = 0; axis < 3; axis += AxesAtOnce)
    {
      StoreTerms<1>(table + 8 * (pairs + 1) + 4 * axis, pairs, d, terms + 4 * axis);
    }
    SurfaceSums<Set> s =
        Together(PairSums(powers, pairs, terms), PairSums(powers, pairs, terms + 4),
                 PairSums(powers, pairs, terms + 8));
    AddZonal(table, pairs, d, s);
    s.Value = s.Value.UnlessFar(d.Excess);
    return s;
  }

  static void Evaluate(const Real* table, int degree, const Real* direction, Real* sample) noexcept
  {
    Direction d(direction);
    const SurfaceSums<Set> s = AllSums(table, degree, d);
    // Makes every derivative NaN where the value is.
    d.Unit = {d.Unit.X.UnlessFar(d.Excess), d.Unit.Y.UnlessFar(d.Excess),
              d.Unit.Z.UnlessFar(d.Excess)};
    if constexpr (Derivatives == 0)
    {
      s.WritePoint(sample);
    }
    else if constexpr (Derivatives == 1)
    {
      s.WriteFirstOrder(d.Unit, sample);
    }
    else
    {
      s.WriteSecondOrder(d.Unit, sample);
    }
  }
};
} // namespace palpate::evaluation
