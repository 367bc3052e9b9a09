#pragma once

#include "RecurrencePoint.h"
#include "SurfaceSums.h"

// A surface at one direction by the normalised recurrence, from a RecurrenceTable of x, y and z
// (the rule of Quartet.h applies here too).

namespace palpate::evaluation
{
template <typename Set, int Derivatives>
struct SurfaceRecurrencePoint
{
  using Real = typename Set::Real;
  using Numbers = Quartet<Set>;
  using Recurrence = RecurrenceSums<Set, 3>;
  using AxisSums = typename Recurrence::template OfAll<Derivatives>;
  using Space = SpaceDerivatives<Set, Real>;
  using Spaces = SpaceDerivatives<Set, Numbers>;
  static constexpr int SampleSize = Derivatives == 0 ? 3 : (Derivatives == 1 ? 15 : 24);

  // Lanes become coordinates.
  static PALPATE_INLINE Numbers Lanes(Real x, Real y, Real z) { return Numbers::Of(x, y, z, 0); }

  static PALPATE_INLINE SurfaceSums<Set> SecondOrder(const AxisSums& sums,
                                                     const LanePowers<Set>& powers)
  {
    const auto of = [&](int i)
    { return SpaceSample<Set>(sums.Function[i], powers, ZonalTerms<Set>(), Real(2)); };
    const SpaceSample<Set> x = of(0);
    const SpaceSample<Set> y = of(1);
    const SpaceSample<Set> z = of(2);
    const auto lanes = [&](Real Space::*part)
    { return Lanes(x.Space.*part, y.Space.*part, z.Space.*part); };
    return {Lanes(x.Value, y.Value, z.Value),
            {lanes(&Space::X), lanes(&Space::Y), lanes(&Space::Z), lanes(&Space::XX),
             lanes(&Space::XY), lanes(&Space::XZ), lanes(&Space::YZ), lanes(&Space::ZZ)}};
  }
  static PALPATE_INLINE SurfaceSums<Set> FirstOrder(const AxisSums& sums,
                                                    const LanePowers<Set>& powers)
  {
    Numbers of[3]; // R and its spatial gradient
    for (int i = 0; i < 3; ++i)
    {
      const auto& axis = sums.Function[i];
      const ComplexQuartet<Set> plane = Turned(axis.First, powers.First);
      of[i] = Sums(Terms(axis.Value, powers.Value), plane.Real, plane.Imaginary,
                   Terms(axis.Slope, powers.Value));
    }
    const auto lanes = [&](int part)
    { return Lanes(of[0].Lane(part), of[1].Lane(part), of[2].Lane(part)); };
    return {lanes(0), {lanes(1), lanes(2), lanes(3), {}, {}, {}, {}, {}}};
  }
  static PALPATE_INLINE SurfaceSums<Set> Point(const AxisSums& sums, const LanePowers<Set>& powers)
  {
    const auto of = [&](int i) { return FinishValue(sums.Function[i], powers, ZonalTerms<Set>()); };
    return {Lanes(of(0), of(1), of(2)), {}};
  }

  static void Evaluate(const Real* table, int degree, const Real* direction, Real* sample) noexcept
  {
    const RecurrenceDirection<Set> d(direction);
    if (!d.IsUnit)
    {
      for (int i = 0; i < SampleSize; ++i)
      {
        sample[i] = Real(__builtin_nan(""));
      }
      return;
    }
    const ComplexQuartet<Set> firstFour = FirstPowers(d.Unit.X, d.Unit.Y);
    const AxisSums sums = Recurrence::template SumBlocks<Derivatives>(table, degree, d, firstFour);
    const LanePowers<Set> powers = Recurrence::Powers(firstFour);
    if constexpr (Derivatives == 0)
    {
      Point(sums, powers).WritePoint(sample);
    }
    else if constexpr (Derivatives == 1)
    {
      FirstOrder(sums, powers).WriteFirstOrder(d.Unit, sample);
    }
    else
    {
      SecondOrder(sums, powers).WriteSecondOrder(d.Unit, sample);
    }
  }
};
} // namespace palpate::evaluation
