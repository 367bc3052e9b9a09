#pragma once

#include "SurfaceHessian.h"

// What both formulations of a surface x(u), y(u), z(u) share (the rule of Quartet.h applies here
// too). Lanes of a Quartet are the coordinates x, y, z and nothing.

namespace palpate::evaluation
{
/// Orthonormal tangents of the unit sphere at u, the same in every lane, with a x b = u. Continuous
/// in each half of the sphere, poles included. Source: Duff et al., J. Computer Graphics Techniques
/// 6 (2017).
template <typename Set>
struct TangentFrame
{
  using Numbers = Quartet<Set>;

  explicit PALPATE_INLINE TangentFrame(const UnitVector<Set>& u)
  {
    const Numbers sign = SignOf(u.Z);
    const Numbers k = Inverse(sign + u.Z);
    const Numbers mixed = Numbers{} - u.X * u.Y * k;
    const Numbers signedX = sign * u.X;
    this->A = {Numbers::All(1) - signedX * u.X * k, sign * mixed, Numbers{} - signedX};
    this->B = {mixed, sign - u.Y * u.Y * k, Numbers{} - u.Y};
  }
  PALPATE_INLINE void Write(typename Set::Real* sample) const
  {
    sample[0] = this->A.X.Lane(0);
    sample[1] = this->A.Y.Lane(0);
    sample[2] = this->A.Z.Lane(0);
    sample[3] = this->B.X.Lane(0);
    sample[4] = this->B.Y.Lane(0);
    sample[5] = this->B.Z.Lane(0);
  }

  UnitVector<Set> A;
  UnitVector<Set> B;
};

/// The point and the derivatives of its extension (SpaceDerivatives).
template <typename Set>
struct SurfaceSums
{
  using Numbers = Quartet<Set>;
  using Real = typename Set::Real;

  PALPATE_INLINE Numbers Along(const UnitVector<Set>& t) const
  {
    return this->Space.X * t.X + this->Space.Y * t.Y + this->Space.Z * t.Z;
  }
  // Of the extension, along s and t.
  PALPATE_INLINE Numbers Along(const UnitVector<Set>& s, const UnitVector<Set>& t) const
  {
    return this->Space.XX * (s.X * t.X - s.Y * t.Y) + this->Space.XY * (s.X * t.Y + s.Y * t.X) +
           this->Space.XZ * (s.X * t.Z + s.Z * t.X) + this->Space.YZ * (s.Y * t.Z + s.Z * t.Y) +
           this->Space.ZZ * (s.Z * t.Z);
  }

  /// Writes X.
  PALPATE_INLINE void WritePoint(Real* sample) const
  {
    sample[0] = this->Value.Lane(0);
    sample[1] = this->Value.Lane(1);
    sample[2] = this->Value.Lane(2);
  }
  // Each row of three overwrites the empty lane of the last one.
  PALPATE_INLINE void WriteTangents(const TangentFrame<Set>& frame, Real* sample) const
  {
    this->Value.Store(sample);
    this->Along(frame.A).Store(sample + 3);
    this->Along(frame.B).Store(sample + 6);
  }
  /// Writes X, X_a, X_b, a and b.
  PALPATE_INLINE void WriteFirstOrder(const UnitVector<Set>& u, Real* sample) const
  {
    const TangentFrame<Set> frame(u);
    this->WriteTangents(frame, sample);
    frame.Write(sample + 9);
  }
  /// Writes X, X_a, X_b, X_aa, X_ab, X_bb, a and b.
  PALPATE_INLINE void WriteSecondOrder(const UnitVector<Set>& u, Real* sample) const
  {
    const TangentFrame<Set> frame(u);
    this->WriteTangents(frame, sample);
    const Numbers radial = this->Along(u);
    (this->Along(frame.A, frame.A) - radial).Store(sample + 9);
    this->Along(frame.A, frame.B).Store(sample + 12);
    (this->Along(frame.B, frame.B) - radial).Store(sample + 15);
    frame.Write(sample + 18);
  }

  Numbers Value;
  SpaceDerivatives<Set, Numbers> Space;
};
} // namespace palpate::evaluation
