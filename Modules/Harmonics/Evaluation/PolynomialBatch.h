#pragma once

#include "EvaluationKernel.h"
#include "PolynomialTerms.h"
#include "SurfaceHessian.h"

// Several directions at once by the polynomials of a PolynomialTable, one direction per lane (the
// rule of Quartet.h applies here too).

namespace palpate::evaluation
{
/// A complex number for each direction.
template <typename Set>
struct ComplexLanes
{
  using Vector = typename Set::PointVector;
  static constexpr int Size = 8; // numbers of a table

  static PALPATE_INLINE ComplexLanes Zero() { return {Vector{}, Vector{}}; }
  /// A coefficient of one order in a block, the same for all directions.
  static PALPATE_INLINE ComplexLanes Load(const typename Set::Real* values)
  {
    return {values[0] - Vector{}, values[4] - Vector{}};
  }

  Vector Real;
  Vector Imaginary;
};

template <typename Set>
PALPATE_INLINE ComplexLanes<Set> operator+(const ComplexLanes<Set>& a, const ComplexLanes<Set>& b)
{
  return {a.Real + b.Real, a.Imaginary + b.Imaginary};
}

template <typename Set>
PALPATE_INLINE ComplexLanes<Set> operator*(const typename Set::PointVector& a,
                                           const ComplexLanes<Set>& b)
{
  return {a * b.Real, a * b.Imaginary};
}

/// Horner's rule in w, from the highest order down, for D_m and for its derivatives in z: the sums
/// and their derivatives in w. As in OrderSums all values are complex conjugates.
template <typename Set, int Derivatives>
struct NestedOrders
{
  using Vector = typename Set::PointVector;
  using Complex = ComplexLanes<Set>;

  PALPATE_INLINE void Step(Complex& sum, const Complex& next) const
  {
    const Vector real = next.Real + sum.Real * this->X + sum.Imaginary * this->Y;
    sum.Imaginary = next.Imaginary + sum.Imaginary * this->X - sum.Real * this->Y;
    sum.Real = real;
  }
  PALPATE_INLINE void Add(const OrderTerms<Complex>& terms)
  {
    if constexpr (Derivatives > 1)
    {
      this->Step(this->HalfSecond, this->First);
      this->Step(this->FirstSlope, this->Slope);
      this->Step(this->Curvature, terms.Curvature);
    }
    if constexpr (Derivatives > 0)
    {
      this->Step(this->First, this->Value);
      this->Step(this->Slope, terms.Slope);
    }
    this->Step(this->Value, terms.Value);
  }

  Vector X;
  Vector Y;
  Complex Value{};
  Complex First{};
  Complex HalfSecond{};
  Complex Slope{};
  Complex FirstSlope{};
  Complex Curvature{};
};

/// The directions of one group of lanes, exactly normalised as in PolynomialDirection.
template <typename Set>
struct LaneDirections
{
  using Vector = typename Set::PointVector;
  using Real = typename Set::Real;

  explicit PALPATE_INLINE LaneDirections(const Real* directions)
  {
    Vector x{};
    Vector y{};
    Vector z{};
    for (int lane = 0; lane < Set::Points; ++lane)
    {
      x[lane] = directions[3 * lane];
      y[lane] = directions[3 * lane + 1];
      z[lane] = directions[3 * lane + 2];
    }
    const Vector square = x * x + y * y;
    this->Excess = square + (z * z - Real(1));
    const Vector shrink = Real(1) - Real(0.5) * this->Excess;
    this->T = (square + square) * this->Excess + (Real(1) - Real(2) * square);
    this->X = x * shrink;
    this->Y = y * shrink;
    this->Z = z * shrink;
  }

  Vector X;
  Vector Y;
  Vector Z;
  Vector T;
  Vector Excess;
};

template <typename Set, int Derivatives>
struct PolynomialBatch
{
  using Vector = typename Set::PointVector;
  using Real = typename Set::Real;
  using Complex = ComplexLanes<Set>;
  using Sums = NestedOrders<Set, Derivatives>;
  static constexpr int SampleSize = Derivatives == 0 ? 1 : (Derivatives == 1 ? 4 : 13);

  // All orders from degree - Above down to 1. The number of coefficients of an order depends only
  // on `Above`, so one piece of code, unrolled, serves every degree. Orders share a block of the
  // table with lower ones that have more coefficients; theirs come last.
  template <int Above>
  static PALPATE_INLINE void AddOrders(const Real* table, int degree, const LaneDirections<Set>& d,
                                       Sums& sums)
  {
    if constexpr (Above < HighestPolynomialDegree)
    {
      if (Above < degree)
      {
        using Order = PolynomialOrder<Complex, Vector, Above, Derivatives>;
        const int before = (degree - Above - 1) / 4; // blocks
        const int lane = (degree - Above - 1) % 4;
        const int highest = Above + lane; // distance of the block's first order from the degree
        const Real* block =
            table + 4 * (degree / 4 + 1) + 8 * before * (degree - 2 * (before - 1)) + lane;
        const int evens = highest / 2 + 1;
        sums.Add(Order::Terms(block + 8 * (evens - Order::EvenCount),
                              block + 8 * (highest + 1 - Order::OddCount), d.T, d.Z));
        AddOrders<Above + 1>(table, degree, d, sums);
      }
    }
  }

  // Order 0: four real polynomials in t^2 side by side, the even and odd powers of E and of O.
  static PALPATE_INLINE void AddZonal(const Real* table, int degree, const LaneDirections<Set>& d,
                                      Sums& sums)
  {
    Complex value{}; // E and O
    Complex slope{}; // and their derivatives in t
    Complex halfCurvature{};
    const auto step = [&](Real even, Real odd)
    {
      halfCurvature = d.T * halfCurvature + slope;
      slope = d.T * slope + value;
      value = d.T * value + Complex{even - Vector{}, odd - Vector{}};
    };
    for (int square = degree / 4; square >= 0; --square, table += 4)
    {
      step(table[1], table[3]);
      step(table[0], table[2]);
    }
    const Vector fourZ = Real(4) * d.Z;
    const Vector slopes = slope.Real + d.Z * slope.Imaginary;
    OrderTerms<Complex> terms = {Complex::Zero(), Complex::Zero(), Complex::Zero()};
    terms.Value.Real = value.Real + d.Z * value.Imaginary;
    terms.Slope.Real = value.Imaginary + fourZ * slopes;
    terms.Curvature.Real =
        slopes + Real(2) * d.Z * slope.Imaginary +
        Real(0.5) * fourZ * fourZ * (halfCurvature.Real + d.Z * halfCurvature.Imaginary);
    sums.Add(terms);
  }

  static PALPATE_INLINE void Write(const Sums& sums, const LaneDirections<Set>& d, Real* samples)
  {
    const Vector value = NanUnlessUnit<Real>(sums.Value.Real, d.Excess);
    if constexpr (Derivatives == 0)
    {
      for (int lane = 0; lane < Set::Points; ++lane)
      {
        samples[lane] = value[lane];
      }
    }
    else if constexpr (Derivatives == 1)
    {
      const Vector gz = NanUnlessUnit<Real>(sums.Slope.Real, d.Excess);
      const Vector radial = sums.First.Real * d.X + sums.First.Imaginary * d.Y + gz * d.Z;
      const Vector x = sums.First.Real - radial * d.X;
      const Vector y = sums.First.Imaginary - radial * d.Y;
      const Vector z = gz - radial * d.Z;
      for (int lane = 0; lane < Set::Points; ++lane)
      {
        samples[4 * lane] = value[lane];
        samples[4 * lane + 1] = x[lane];
        samples[4 * lane + 2] = y[lane];
        samples[4 * lane + 3] = z[lane];
      }
    }
    else
    {
      const SpaceDerivatives<Set, Vector> space{sums.First.Real,
                                                sums.First.Imaginary,
                                                NanUnlessUnit<Real>(sums.Slope.Real, d.Excess),
                                                sums.HalfSecond.Real + sums.HalfSecond.Real,
                                                sums.HalfSecond.Imaginary +
                                                    sums.HalfSecond.Imaginary,
                                                sums.FirstSlope.Real,
                                                sums.FirstSlope.Imaginary,
                                                Real(4) * sums.Curvature.Real};
      const auto s = ToSurface<Set, Vector>(space, d.X, d.Y, d.Z);
      for (int lane = 0; lane < Set::Points; ++lane)
      {
        WriteSecondOrder<Set>(value[lane],
                              {s.X[lane], s.Y[lane], s.Z[lane], s.XX[lane], s.XY[lane], s.XZ[lane],
                               s.YY[lane], s.YZ[lane], s.ZZ[lane]},
                              samples + 13 * lane);
      }
    }
  }

  static void Evaluate(const Real* table, int degree, const Real* directions, long count,
                       Real* samples) noexcept
  {
    // The last directions form their own group, padded with the last one, so that a result does not
    // depend on the number of directions.
    Real lastDirections[3 * Set::Points];
    Real lastSamples[SampleSize * Set::Points];
    for (long at = 0; at < count; at += Set::Points)
    {
      const bool whole = at + Set::Points <= count;
      for (int i = 0; !whole && i < 3 * Set::Points; ++i)
      {
        const long from = 3 * at + i;
        lastDirections[i] = directions[from < 3 * count ? from : 3 * (count - 1) + i % 3];
      }
      const LaneDirections<Set> d(whole ? directions + 3 * at : lastDirections);
      Sums sums;
      sums.X = d.X;
      sums.Y = d.Y;
      AddOrders<0>(table, degree, d, sums);
      AddZonal(table, degree, d, sums);
      Write(sums, d, whole ? samples + SampleSize * at : lastSamples);
      for (long i = 0; !whole && i < SampleSize * (count - at); ++i)
      {
        samples[SampleSize * at + i] = lastSamples[i];
      }
    }
  }
};
} // namespace palpate::evaluation
