#pragma once

#include "SurfaceHessian.h"

// Several directions at once by the polynomials of a PolynomialTable, one direction a lane (the
// rule of Quartet.h holds here too).

namespace palpate::evaluation
{
/// Horner's rule in t for one order, and for the derivatives in t, the k-th divided by k!.
template <typename Set, int Derivatives>
struct LanePolynomial
{
  using Vector = typename Set::PointVector;

  PALPATE_INLINE void Step(const Vector& t, typename Set::Real cosine, typename Set::Real sine)
  {
    for (int k = Derivatives; k > 0; --k)
    {
      this->Cosine[k] = this->Cosine[k] * t + this->Cosine[k - 1];
      this->Sine[k] = this->Sine[k] * t + this->Sine[k - 1];
    }
    this->Cosine[0] = this->Cosine[0] * t + cosine;
    this->Sine[0] = this->Sine[0] * t + sine;
  }

  Vector Cosine[Derivatives + 1]{};
  Vector Sine[Derivatives + 1]{};
};

/// Horner's rule in w, from the highest order down, for D_m and for its derivatives in z: the sums
/// and their derivatives in w.
template <typename Set, int Derivatives>
struct NestedOrders
{
  using Vector = typename Set::PointVector;

  struct Complex
  {
    Vector Real{};
    Vector Imaginary{};
  };

  PALPATE_INLINE void Step(Complex& sum, const Vector& real, const Vector& imaginary) const
  {
    const Vector next = sum.Real * this->X - sum.Imaginary * this->Y + real;
    sum.Imaginary = sum.Real * this->Y + sum.Imaginary * this->X + imaginary;
    sum.Real = next;
  }

  /// D_m and derivatives of one order; the sine terms are minus the imaginary parts.
  PALPATE_INLINE void Add(const Vector* cosine, const Vector* sine)
  {
    if constexpr (Derivatives > 1)
    {
      this->Step(this->HalfSecond, this->First.Real, this->First.Imaginary);
      this->Step(this->FirstSlope, this->Slope.Real, this->Slope.Imaginary);
      this->Step(this->Curvature, cosine[2], -sine[2]);
    }
    if constexpr (Derivatives > 0)
    {
      this->Step(this->First, this->Value.Real, this->Value.Imaginary);
      this->Step(this->Slope, cosine[1], -sine[1]);
    }
    this->Step(this->Value, cosine[0], -sine[0]);
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
    const Vector twice = square + square;
    this->Excess = square + (z * z - Real(1));
    const Vector shrink = Real(1) - Real(0.5) * this->Excess;
    this->T = twice * this->Excess + (Real(1) - twice);
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
  using Polynomial = LanePolynomial<Set, Derivatives>;
  using Sums = NestedOrders<Set, Derivatives>;
  static constexpr int SampleSize = Derivatives == 0 ? 1 : (Derivatives == 1 ? 4 : 13);

  // D = E + z O and its derivatives in z; see PolynomialPoint.
  static PALPATE_INLINE void AddTerms(const Polynomial& even, const Polynomial& odd,
                                      const Vector& z, Sums& sums)
  {
    Vector cosine[Derivatives + 1] = {even.Cosine[0] + z * odd.Cosine[0]};
    Vector sine[Derivatives + 1] = {even.Sine[0] + z * odd.Sine[0]};
    const Vector fourZ = Real(4) * z;
    if constexpr (Derivatives > 0)
    {
      cosine[1] = odd.Cosine[0] + fourZ * (even.Cosine[1] + z * odd.Cosine[1]);
      sine[1] = odd.Sine[0] + fourZ * (even.Sine[1] + z * odd.Sine[1]);
    }
    if constexpr (Derivatives > 1)
    {
      const Vector threeZ = Real(3) * z;
      const Vector squares = Real(2) * fourZ * fourZ;
      cosine[2] = Real(4) * (even.Cosine[1] + threeZ * odd.Cosine[1]) +
                  squares * (even.Cosine[2] + z * odd.Cosine[2]);
      sine[2] = Real(4) * (even.Sine[1] + threeZ * odd.Sine[1]) +
                squares * (even.Sine[2] + z * odd.Sine[2]);
    }
    sums.Add(cosine, sine);
  }

  // The orders of one block, the highest first. Higher orders of a block have fewer terms; their
  // first ones are zeros in the table and left out.
  static PALPATE_INLINE void AddBlock(const Real* block, int degree, int first,
                                      const LaneDirections<Set>& d, Sums& sums)
  {
    const int blockEven = (degree - first) / 2 + 1;
    const int blockOdd = (degree - first + 1) / 2;
    for (int lane = degree - first < 3 ? degree - first : 3; lane >= 0; --lane)
    {
      const int evenCount = (degree - first - lane) / 2 + 1;
      const int oddCount = (degree - first - lane + 1) / 2;
      const Real* evenTerm = block + lane + 8 * (blockEven - evenCount);
      const Real* oddTerm = block + lane + 8 * (blockEven + blockOdd - oddCount);
      Polynomial even;
      Polynomial odd;
      if (evenCount > oddCount)
      {
        even.Cosine[0] += evenTerm[0];
        even.Sine[0] += evenTerm[4];
        evenTerm += 8;
      }
      for (int k = 0; k < oddCount; ++k, evenTerm += 8, oddTerm += 8)
      {
        even.Step(d.T, evenTerm[0], evenTerm[4]);
        odd.Step(d.T, oddTerm[0], oddTerm[4]);
      }
      AddTerms(even, odd, d.Z, sums);
    }
  }

  // Order 0 has its even and odd powers of t side by side, and no sine terms.
  static PALPATE_INLINE void AddZonal(const Real* table, int degree, const LaneDirections<Set>& d,
                                      Sums& sums)
  {
    Polynomial even;
    Polynomial odd;
    for (int square = degree / 4; square >= 0; --square, table += 4)
    {
      even.Step(d.T, table[1], Real(0));
      odd.Step(d.T, table[3], Real(0));
      even.Step(d.T, table[0], Real(0));
      odd.Step(d.T, table[2], Real(0));
    }
    AddTerms(even, odd, d.Z, sums);
  }

  static PALPATE_INLINE Sums SumOrders(const Real* table, int degree, const LaneDirections<Set>& d)
  {
    Sums sums;
    sums.X = d.X;
    sums.Y = d.Y;
    const Real* block = table + 4 * (degree / 4 + 1);
    for (int first = 1; first <= degree; first += 4)
    {
      block += 8 * (degree - first + 1);
    }
    for (int first = 1 + (degree - 1) / 4 * 4; degree > 0 && first >= 1; first -= 4)
    {
      block -= 8 * (degree - first + 1);
      AddBlock(block, degree, first, d, sums);
    }
    AddZonal(table, degree, d, sums);
    return sums;
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
      const Vector radial = sums.First.Real * d.X - sums.First.Imaginary * d.Y + gz * d.Z;
      const Vector x = sums.First.Real - radial * d.X;
      const Vector y = -sums.First.Imaginary - radial * d.Y;
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
                                                -sums.First.Imaginary,
                                                NanUnlessUnit<Real>(sums.Slope.Real, d.Excess),
                                                sums.HalfSecond.Real + sums.HalfSecond.Real,
                                                -sums.HalfSecond.Imaginary -
                                                    sums.HalfSecond.Imaginary,
                                                sums.FirstSlope.Real,
                                                -sums.FirstSlope.Imaginary,
                                                sums.Curvature.Real};
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

  static PALPATE_INLINE void EvaluateLanes(const Real* table, int degree, const Real* directions,
                                           Real* samples)
  {
    const LaneDirections<Set> d(directions);
    Write(SumOrders(table, degree, d), d, samples);
  }

  static void Evaluate(const Real* table, int degree, const Real* directions, long count,
                       Real* samples) noexcept
  {
    long at = 0;
    for (; at + Set::Points <= count; at += Set::Points)
    {
      EvaluateLanes(table, degree, directions + 3 * at, samples + SampleSize * at);
    }
    if (at == count)
    {
      return;
    }
    // The last ones in a group of their own, filled up with the last direction: so a result never
    // depends on how many directions came with it.
    Real lastDirections[3 * Set::Points];
    Real lastSamples[SampleSize * Set::Points];
    for (int i = 0; i < 3 * Set::Points; ++i)
    {
      const long from = 3 * at + i;
      lastDirections[i] = directions[from < 3 * count ? from : 3 * (count - 1) + i % 3];
    }
    EvaluateLanes(table, degree, lastDirections, lastSamples);
    for (long i = 0; i < SampleSize * (count - at); ++i)
    {
      samples[SampleSize * at + i] = lastSamples[i];
    }
  }
};
} // namespace palpate::evaluation
