#pragma once

// Four numbers, one for each of four consecutive orders. This header and those that refer to its
// rule are compiled once per instruction set, with different options, so they must not contain or
// include anything that another file could also instantiate: the linker would keep one copy,
// perhaps the one for the wrong processor. So everything in them is templated on the instruction
// set, and nothing else is included.
//
// `Set` describes an instruction set and a precision: `Real`; `Vector`, a vector of `Lanes` of them
// (the vector extension of GCC and Clang; Lanes divides 4); `PointVector` of `Points`, for several
// directions at once; and Spread, which broadcasts a number to a Vector.

#define PALPATE_INLINE inline __attribute__((always_inline))

namespace palpate::evaluation
{
/// Directions are unit vectors up to rounding, perhaps to float; any other vector's squared length
/// differs from 1 by more than this.
template <typename Real>
struct UnitLength
{
  static constexpr Real Tolerance = Real(1e-3);
};

/// `values`, or NaN in the lanes where |excess| is above the tolerance.
template <typename Real, typename Vector>
PALPATE_INLINE Vector NanUnlessUnit(const Vector& values, const Vector& excess)
{
  const Vector squares = excess * excess;
  const Vector limit = Vector{} + UnitLength<Real>::Tolerance * UnitLength<Real>::Tolerance;
  const auto far = limit < squares;
  using Bits = decltype(far);
  return (Vector)((Bits)values | far); // all bits set is NaN
}

template <typename Set>
struct Quartet
{
  using Real = typename Set::Real;
  using Vector = typename Set::Vector;
  static constexpr int Parts = 4 / Set::Lanes;

  static PALPATE_INLINE Quartet All(Real value)
  {
    Quartet result;
    const Vector spread = Set::Spread(value);
    for (Vector& part : result.Part)
    {
      part = spread;
    }
    return result;
  }
  static PALPATE_INLINE Quartet Of(Real a, Real b, Real c, Real d)
  {
    if constexpr (Parts == 1)
    {
      return {{Vector{a, b, c, d}}};
    }
    else
    {
      return {{Vector{a, b}, Vector{c, d}}};
    }
  }
  static PALPATE_INLINE Quartet Load(const Real* values)
  {
    Quartet result;
    for (int i = 0; i < Parts; ++i)
    {
      result.Part[i] =
          *reinterpret_cast<const typename Set::StoredVector*>(values + i * Set::Lanes);
    }
    return result;
  }
  PALPATE_INLINE void Store(Real* values) const
  {
    for (int i = 0; i < Parts; ++i)
    {
      *reinterpret_cast<typename Set::StoredVector*>(values + i * Set::Lanes) = this->Part[i];
    }
  }
  PALPATE_INLINE Real Lane(int lane) const
  {
    return this->Part[lane / Set::Lanes][lane % Set::Lanes];
  }
  PALPATE_INLINE Real Sum() const
  {
    if constexpr (Parts == 1)
    {
      const Vector& v = this->Part[0];
      return (v[0] + v[2]) + (v[1] + v[3]);
    }
    else
    {
      const Vector v = this->Part[0] + this->Part[1];
      return v[0] + v[1];
    }
  }

  /// These numbers, or NaN where `excess` shows that a direction is not a unit vector.
  PALPATE_INLINE Quartet UnlessFar(const Quartet& excess) const
  {
    Quartet result;
    for (int i = 0; i < Parts; ++i)
    {
      result.Part[i] = NanUnlessUnit<Real>(this->Part[i], excess.Part[i]);
    }
    return result;
  }

  Vector Part[Parts];
};

template <typename Set>
PALPATE_INLINE Quartet<Set> operator+(const Quartet<Set>& a, const Quartet<Set>& b)
{
  Quartet<Set> result;
  for (int i = 0; i < Quartet<Set>::Parts; ++i)
  {
    result.Part[i] = a.Part[i] + b.Part[i];
  }
  return result;
}

template <typename Set>
PALPATE_INLINE Quartet<Set> operator-(const Quartet<Set>& a, const Quartet<Set>& b)
{
  Quartet<Set> result;
  for (int i = 0; i < Quartet<Set>::Parts; ++i)
  {
    result.Part[i] = a.Part[i] - b.Part[i];
  }
  return result;
}

template <typename Set>
PALPATE_INLINE Quartet<Set> operator*(const Quartet<Set>& a, const Quartet<Set>& b)
{
  Quartet<Set> result;
  for (int i = 0; i < Quartet<Set>::Parts; ++i)
  {
    result.Part[i] = a.Part[i] * b.Part[i];
  }
  return result;
}

/// 1 or -1 where the number is negative.
template <typename Set>
PALPATE_INLINE Quartet<Set> SignOf(const Quartet<Set>& a)
{
  Quartet<Set> result;
  for (int i = 0; i < Quartet<Set>::Parts; ++i)
  {
    const typename Set::Vector one = typename Set::Vector{} + typename Set::Real(1);
    result.Part[i] = a.Part[i] < typename Set::Vector{} ? -one : one;
  }
  return result;
}

template <typename Set>
PALPATE_INLINE Quartet<Set> Inverse(const Quartet<Set>& a)
{
  Quartet<Set> result;
  for (int i = 0; i < Quartet<Set>::Parts; ++i)
  {
    result.Part[i] = typename Set::Real(1) / a.Part[i];
  }
  return result;
}

/// b0 a0 a1 a2 of `a` with `first` prepended: one order further.
template <typename Set>
PALPATE_INLINE Quartet<Set> Shifted(const Quartet<Set>& first, const Quartet<Set>& a)
{
  if constexpr (Quartet<Set>::Parts == 1)
  {
    return {{__builtin_shufflevector(first.Part[0], a.Part[0], 0, 4, 5, 6)}};
  }
  else
  {
    return {{__builtin_shufflevector(first.Part[0], a.Part[0], 0, 2),
             __builtin_shufflevector(a.Part[0], a.Part[1], 1, 2)}};
  }
}

/// a3 a0 a1 a2.
template <typename Set>
PALPATE_INLINE Quartet<Set> Rotated(const Quartet<Set>& a)
{
  if constexpr (Quartet<Set>::Parts == 1)
  {
    return {{__builtin_shufflevector(a.Part[0], a.Part[0], 3, 0, 1, 2)}};
  }
  else
  {
    return {{__builtin_shufflevector(a.Part[1], a.Part[0], 1, 2),
             __builtin_shufflevector(a.Part[0], a.Part[1], 1, 2)}};
  }
}

/// a0 b1 b2 b3.
template <typename Set>
PALPATE_INLINE Quartet<Set> WithFirstLane(const Quartet<Set>& a, const Quartet<Set>& b)
{
  if constexpr (Quartet<Set>::Parts == 1)
  {
    return {{__builtin_shufflevector(a.Part[0], b.Part[0], 0, 5, 6, 7)}};
  }
  else
  {
    return {{__builtin_shufflevector(a.Part[0], b.Part[0], 0, 3), b.Part[1]}};
  }
}

/// a2 a3 b0 b1.
template <typename Set>
PALPATE_INLINE Quartet<Set> Joined(const Quartet<Set>& a, const Quartet<Set>& b)
{
  if constexpr (Quartet<Set>::Parts == 1)
  {
    return {{__builtin_shufflevector(a.Part[0], b.Part[0], 2, 3, 4, 5)}};
  }
  else
  {
    return {{a.Part[1], b.Part[0]}};
  }
}

/// a1 a0 a3 a2: real and imaginary parts of interleaved complex numbers exchanged.
template <typename Set>
PALPATE_INLINE Quartet<Set> Exchanged(const Quartet<Set>& a)
{
  Quartet<Set> result;
  for (int i = 0; i < Quartet<Set>::Parts; ++i)
  {
    if constexpr (Quartet<Set>::Parts == 1)
    {
      result.Part[i] = __builtin_shufflevector(a.Part[i], a.Part[i], 1, 0, 3, 2);
    }
    else
    {
      result.Part[i] = __builtin_shufflevector(a.Part[i], a.Part[i], 1, 0);
    }
  }
  return result;
}

/// The last lane of `a` in every lane.
template <typename Set>
PALPATE_INLINE Quartet<Set> LastLane(const Quartet<Set>& a)
{
  if constexpr (Quartet<Set>::Parts == 1)
  {
    return {{__builtin_shufflevector(a.Part[0], a.Part[0], 3, 3, 3, 3)}};
  }
  else
  {
    const auto last = __builtin_shufflevector(a.Part[1], a.Part[1], 1, 1);
    return {{last, last}};
  }
}

/// a0 b1 a2 b3.
template <typename Set>
PALPATE_INLINE Quartet<Set> Alternate(const Quartet<Set>& a, const Quartet<Set>& b)
{
  if constexpr (Quartet<Set>::Parts == 1)
  {
    return {{__builtin_shufflevector(a.Part[0], b.Part[0], 0, 5, 2, 7)}};
  }
  else
  {
    return {{__builtin_shufflevector(a.Part[0], b.Part[0], 0, 3),
             __builtin_shufflevector(a.Part[1], b.Part[1], 0, 3)}};
  }
}

/// a0 a1 b2 b3.
template <typename Set>
PALPATE_INLINE Quartet<Set> Halves(const Quartet<Set>& a, const Quartet<Set>& b)
{
  if constexpr (Quartet<Set>::Parts == 1)
  {
    return {{__builtin_shufflevector(a.Part[0], b.Part[0], 0, 1, 6, 7)}};
  }
  else
  {
    return {{a.Part[0], b.Part[1]}};
  }
}

/// The sums of a, of b, of c and of d, by one transposition instead of four reductions.
template <typename Set>
PALPATE_INLINE Quartet<Set> Sums(const Quartet<Set>& a, const Quartet<Set>& b,
                                 const Quartet<Set>& c, const Quartet<Set>& d)
{
  using Vector = typename Set::Vector;
  if constexpr (Quartet<Set>::Parts == 1)
  {
    const Vector ab = __builtin_shufflevector(a.Part[0], b.Part[0], 0, 4, 2, 6) +
                      __builtin_shufflevector(a.Part[0], b.Part[0], 1, 5, 3, 7);
    const Vector cd = __builtin_shufflevector(c.Part[0], d.Part[0], 0, 4, 2, 6) +
                      __builtin_shufflevector(c.Part[0], d.Part[0], 1, 5, 3, 7);
    return {{__builtin_shufflevector(ab, cd, 0, 1, 4, 5) +
             __builtin_shufflevector(ab, cd, 2, 3, 6, 7)}};
  }
  else
  {
    const Vector a2 = a.Part[0] + a.Part[1];
    const Vector b2 = b.Part[0] + b.Part[1];
    const Vector c2 = c.Part[0] + c.Part[1];
    const Vector d2 = d.Part[0] + d.Part[1];
    return {{__builtin_shufflevector(a2, b2, 0, 2) + __builtin_shufflevector(a2, b2, 1, 3),
             __builtin_shufflevector(c2, d2, 0, 2) + __builtin_shufflevector(c2, d2, 1, 3)}};
  }
}

/// Four complex numbers. Copied part by part, since GCC would otherwise copy through memory.
template <typename Set>
struct ComplexQuartet
{
  static constexpr int Size = 8; // numbers of a table

  ComplexQuartet() = default;
  PALPATE_INLINE ComplexQuartet(const Quartet<Set>& real, const Quartet<Set>& imaginary)
      : Real(real), Imaginary(imaginary)
  {
  }
  static PALPATE_INLINE ComplexQuartet Zero() { return {Quartet<Set>{}, Quartet<Set>{}}; }
  /// Four real parts, then four imaginary parts.
  static PALPATE_INLINE ComplexQuartet Load(const typename Set::Real* values)
  {
    return {Quartet<Set>::Load(values), Quartet<Set>::Load(values + 4)};
  }
  PALPATE_INLINE ComplexQuartet(const ComplexQuartet& other)
      : Real(other.Real), Imaginary(other.Imaginary)
  {
  }
  PALPATE_INLINE ComplexQuartet& operator=(const ComplexQuartet& other)
  {
    this->Real = other.Real;
    this->Imaginary = other.Imaginary;
    return *this;
  }

  Quartet<Set> Real;
  Quartet<Set> Imaginary;
};

template <typename Set>
PALPATE_INLINE ComplexQuartet<Set> Rotated(const ComplexQuartet<Set>& a)
{
  return {Rotated(a.Real), Rotated(a.Imaginary)};
}

template <typename Set>
PALPATE_INLINE ComplexQuartet<Set> WithFirstLane(const ComplexQuartet<Set>& a,
                                                 const ComplexQuartet<Set>& b)
{
  return {WithFirstLane(a.Real, b.Real), WithFirstLane(a.Imaginary, b.Imaginary)};
}

template <typename Set>
PALPATE_INLINE ComplexQuartet<Set> Halves(const ComplexQuartet<Set>& a,
                                          const ComplexQuartet<Set>& b)
{
  return {Halves(a.Real, b.Real), Halves(a.Imaginary, b.Imaginary)};
}

template <typename Set>
PALPATE_INLINE ComplexQuartet<Set> operator+(const ComplexQuartet<Set>& a,
                                             const ComplexQuartet<Set>& b)
{
  return {a.Real + b.Real, a.Imaginary + b.Imaginary};
}

template <typename Set>
PALPATE_INLINE ComplexQuartet<Set> operator*(const ComplexQuartet<Set>& a,
                                             const ComplexQuartet<Set>& b)
{
  return {a.Real * b.Real - a.Imaginary * b.Imaginary, a.Real * b.Imaginary + a.Imaginary * b.Real};
}

template <typename Set>
PALPATE_INLINE ComplexQuartet<Set> Square(const ComplexQuartet<Set>& a)
{
  return {a.Real * a.Real - a.Imaginary * a.Imaginary, (a.Real + a.Real) * a.Imaginary};
}

template <typename Set>
PALPATE_INLINE ComplexQuartet<Set> operator*(const Quartet<Set>& a, const ComplexQuartet<Set>& b)
{
  return {a * b.Real, a * b.Imaginary};
}

/// d conj(w). A term Re((c - i s) w) of a sum keeps d = c + i s; then the real part of this is the
/// term, and its imaginary part the same with i w instead of w.
template <typename Set>
PALPATE_INLINE ComplexQuartet<Set> Turned(const ComplexQuartet<Set>& d,
                                          const ComplexQuartet<Set>& w)
{
  return {d.Real * w.Real + d.Imaginary * w.Imaginary, d.Imaginary * w.Real - d.Real * w.Imaginary};
}

/// The real part of d conj(w).
template <typename Set>
PALPATE_INLINE Quartet<Set> Terms(const ComplexQuartet<Set>& d, const ComplexQuartet<Set>& w)
{
  return d.Real * w.Real + d.Imaginary * w.Imaginary;
}

/// The same, added to `sum`.
template <typename Set>
PALPATE_INLINE Quartet<Set> AddTerms(const Quartet<Set>& sum, const ComplexQuartet<Set>& d,
                                     const ComplexQuartet<Set>& w)
{
  return sum + d.Real * w.Real + d.Imaginary * w.Imaginary;
}
} // namespace palpate::evaluation
