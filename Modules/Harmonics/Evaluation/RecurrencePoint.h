#pragma once

#include "SurfaceHessian.h"

// One direction by the normalised recurrence, from a RecurrenceTable (the rule of Quartet.h applies
// here too).

namespace palpate::evaluation
{
/// The exactly normalised direction, and its distance from the nearer pole: d = 1 - |z|, from x and
/// y, since near a pole the rounding of z itself would dominate the error at high degrees.
template <typename Set>
struct RecurrenceDirection
{
  using Real = typename Set::Real;
  using Numbers = Quartet<Set>;

  explicit PALPATE_INLINE RecurrenceDirection(const Real* direction)
  {
    const Real x = direction[0];
    const Real y = direction[1];
    const Real z = direction[2];
    const Real square = x * x + y * y;
    const Real squares = square + z * z;
    const Real length = __builtin_sqrt(squares);
    const Real inverse = 1 / length;
    this->South = z < 0;
    this->IsUnit = __builtin_fabs(squares - 1) <= UnitLength<Real>::Tolerance;
    this->Depth = Numbers::All(square / (squares + (this->South ? -z : z) * length));
    this->Unit = {Numbers::All(x * inverse), Numbers::All(y * inverse), Numbers::All(z * inverse)};
  }

  UnitVector<Set> Unit;
  Numbers Depth; // 1 - |z|
  bool South;
  bool IsUnit;
};

/// State of the recurrence over the degrees of four orders: Q, or a derivative of it in z (the k-th
/// divided by k!), and the sums of c Q and s Q of each function so far.
template <typename Set, int Functions>
struct ColumnLevel
{
  using Numbers = Quartet<Set>;

  struct Constants
  {
    Numbers Ratio;
    Numbers Carry;
    Numbers Drop;
  };

  template <bool South>
  PALPATE_INLINE void Advance(const Constants& by)
  {
    if constexpr (South)
    {
      this->Difference = by.Drop * this->Value - by.Carry * this->Difference;
      this->Value = this->Difference - by.Ratio * this->Value;
    }
    else
    {
      this->Difference = by.Carry * this->Difference - by.Drop * this->Value;
      this->Value = this->Difference + by.Ratio * this->Value;
    }
  }
  /// `lower` is the derivative's extra term by the product rule: the slope times the level below.
  template <bool South>
  PALPATE_INLINE void Advance(const Constants& by, const Numbers& lower)
  {
    if constexpr (South)
    {
      this->Difference = lower + by.Drop * this->Value - by.Carry * this->Difference;
      this->Value = this->Difference - by.Ratio * this->Value;
    }
    else
    {
      this->Difference = lower + by.Carry * this->Difference - by.Drop * this->Value;
      this->Value = this->Difference + by.Ratio * this->Value;
    }
  }
  /// `coefficients` of the degree: cosine and sine of each function.
  PALPATE_INLINE void Collect(const typename Set::Real* coefficients)
  {
    for (int i = 0; i < Functions; ++i)
    {
      this->Cosines[i] = this->Cosines[i] + Numbers::Load(coefficients + 8 * i) * this->Value;
      this->Sines[i] = this->Sines[i] + Numbers::Load(coefficients + 8 * i + 4) * this->Value;
    }
  }
  PALPATE_INLINE void Scale(const Numbers& factor)
  {
    this->Value = this->Value * factor;
    this->Difference = this->Difference * factor;
    for (int i = 0; i < Functions; ++i)
    {
      this->Cosines[i] = this->Cosines[i] * factor;
      this->Sines[i] = this->Sines[i] * factor;
    }
  }
  PALPATE_INLINE bool Exceeds(typename Set::Real limit) const
  {
    bool exceeds = false;
    for (int lane = 0; lane < 4; ++lane)
    {
      exceeds = exceeds || __builtin_fabs(this->Value.Lane(lane)) > limit ||
                __builtin_fabs(this->Difference.Lane(lane)) > limit;
    }
    return exceeds;
  }
  PALPATE_INLINE ComplexQuartet<Set> Sum(int function) const
  {
    return {this->Cosines[function], this->Sines[function]};
  }

  Numbers Value{};
  Numbers Difference{};
  Numbers Cosines[Functions]{};
  Numbers Sines[Functions]{};
};

/// Four orders through all their degrees. Q at degree l is r Q + D with the difference D from the
/// value at the pole, D = g D - a d Q in terms of degree l - 1; in the south the sign of every
/// other degree changes. Near a pole D is small, and so is its rounding.
template <typename Set, int Functions, int Derivatives, bool South>
struct Column
{
  using Real = typename Set::Real;
  using Numbers = Quartet<Set>;
  using Level = ColumnLevel<Set, Functions>;
  static constexpr int FirstRowSize = 4 + 8 * Functions;
  static constexpr int RowSize = 12 + 8 * Functions;

  /// Starts at the rows of RecurrenceTable for one block.
  PALPATE_INLINE Column(const Real* table, const Numbers& depth)
      : Row(table + FirstRowSize), Depth(depth)
  {
    this->Level0.Value = Numbers::Load(table);
    this->Level0.Collect(table + 4);
  }
  /// Where the next block starts, `degrees` rows after the first of this one.
  static PALPATE_INLINE const Real* NextBlock(const Real* table, int degrees)
  {
    return table + FirstRowSize + RowSize * degrees;
  }

  PALPATE_INLINE void Advance()
  {
    const Real* row = this->Row;
    this->Row += RowSize;
    const Numbers slope = Numbers::Load(row + 8);
    const typename Level::Constants by{Numbers::Load(row), Numbers::Load(row + 4),
                                       slope * this->Depth};
    const Real* coefficients = row + 12;
    if constexpr (Derivatives > 1)
    {
      this->Level2.template Advance<South>(by, slope * this->Level1.Value);
      this->Level2.Collect(coefficients);
    }
    if constexpr (Derivatives > 0)
    {
      this->Level1.template Advance<South>(by, slope * this->Level0.Value);
      this->Level1.Collect(coefficients);
    }
    this->Level0.template Advance<South>(by);
    this->Level0.Collect(coefficients);
  }
  PALPATE_INLINE void Run(int degrees)
  {
    for (int i = 0; i < degrees; ++i)
    {
      this->Advance();
    }
  }
  /// Interleaves two columns, since each step of one depends on its last.
  PALPATE_INLINE void RunWith(Column& other, int degrees)
  {
    for (int i = 0; i < degrees; ++i)
    {
      this->Advance();
      other.Advance();
    }
  }

  /// Runs while the numbers are scaled by 2^(scale ScaleBits), and lowers the scale as they grow.
  PALPATE_INLINE void RunScaled(int degrees, int& scale)
  {
    constexpr int Stride = 8; // numbers grow by less than 2^11 per degree up to degree 10^6
    while (scale > 0 && degrees > 0)
    {
      const int count = degrees < Stride ? degrees : Stride;
      this->Run(count);
      degrees -= count;
      if (this->Level0.Exceeds(Set::ScaleUp) || this->Level1.Exceeds(Set::ScaleUp) ||
          this->Level2.Exceeds(Set::ScaleUp))
      {
        const Numbers factor = Numbers::All(1 / Set::ScaleUp);
        this->Level0.Scale(factor);
        this->Level1.Scale(factor);
        this->Level2.Scale(factor);
        --scale;
      }
    }
    this->Run(degrees);
  }

  PALPATE_INLINE OrderTerms<ComplexQuartet<Set>> Terms(int function) const
  {
    OrderTerms<ComplexQuartet<Set>> terms;
    terms.Value = this->Level0.Sum(function);
    terms.Slope = this->Level1.Sum(function);
    terms.Curvature = this->Level2.Sum(function);
    return terms;
  }

  Level Level0;
  Level Level1;
  Level Level2;
  const Real* Row;
  Numbers Depth;
};

/// The powers of w^4 of a block and of the previous one, times 2^(Scale ScaleBits) so that no power
/// that can still contribute underflows.
template <typename Set>
struct ScaledPower
{
  using Real = typename Set::Real;
  using Numbers = Quartet<Set>;
  using Complexes = ComplexQuartet<Set>;

  PALPATE_INLINE void Advance(const Complexes& fourthPower)
  {
    this->Before = this->Power;
    this->Power = this->Power * fourthPower;
    const Real real = this->Power.Real.Lane(0);
    const Real imaginary = this->Power.Imaginary.Lane(0);
    const Real size = __builtin_fabs(real) + __builtin_fabs(imaginary);
    if (size < 1 / Set::ScaleUp)
    {
      const Numbers factor = Numbers::All(Set::ScaleUp);
      this->Power = factor * this->Power;
      this->Before = factor * this->Before;
      ++this->Scale;
    }
  }

  Complexes Power{Numbers::All(1), Numbers{}};
  Complexes Before{Numbers{}, Numbers{}};
  int Scale = 0;
};

/// The sums over the orders of several functions of any degree at one direction.
template <typename Set, int Functions>
struct RecurrenceSums
{
  using Real = typename Set::Real;
  using Numbers = Quartet<Set>;
  using Complexes = ComplexQuartet<Set>;
  using Direction = RecurrenceDirection<Set>;

  template <int Derivatives>
  struct OfAll
  {
    OrderSums<Set, Derivatives> Function[Functions]{};
  };

  static PALPATE_INLINE LanePowers<Set> Powers(const Complexes& firstFour)
  {
    LanePowers<Set> powers;
    powers.Value = {Shifted(Numbers::All(1), firstFour.Real),
                    Shifted(Numbers{}, firstFour.Imaginary)};
    powers.First = Rotated(powers.Value);
    powers.Second = Rotated(powers.First);
    powers.FirstTimesW = Rotated(firstFour);
    return powers;
  }

  // A column of Q grows by less than 2^degree: with this scale nothing contributes any more.
  static PALPATE_INLINE bool IsLost(const ScaledPower<Set>& power, int degree)
  {
    return (power.Scale - 1) * Set::ScaleBits > degree;
  }

  // Adds a block; its terms are scaled by 2^(scale ScaleBits).
  template <int Derivatives, bool South>
  static PALPATE_INLINE void Add(const Column<Set, Functions, Derivatives, South>& column,
                                 int first, int scale, const ScaledPower<Set>& power,
                                 OfAll<Derivatives>& sums)
  {
    const Numbers factor =
        Numbers::All(scale == 0 ? Real(1) : (scale == 1 ? 1 / Set::ScaleUp : Real(0)));
    const Complexes value = factor * power.Power;
    const Complexes before = factor * power.Before;
    const Numbers orders = Numbers::Of(0, 1, 2, 3) + Numbers::All(static_cast<Real>(first));
    for (int i = 0; i < Functions; ++i)
    {
      sums.Function[i].Add(
          {column.Terms(i), orders, value, WithFirstLane(before, value), Halves(before, value)});
    }
  }

  // Adds up to two blocks starting at order `first`. Returns the start of the next ones.
  template <int Derivatives, bool South>
  static PALPATE_INLINE const Real* AddPair(const Real* table, int degree, int first,
                                            const Direction& d, const ScaledPower<Set>& power,
                                            const ScaledPower<Set>& nextPower,
                                            OfAll<Derivatives>& sums)
  {
    using BlockColumn = Column<Set, Functions, Derivatives, South>;
    const int degrees = degree - first;
    const Real* next = BlockColumn::NextBlock(table, degrees);
    const Real* afterNext = BlockColumn::NextBlock(next, degrees - 4);
    const bool both = degrees >= 4 && !IsLost(nextPower, degree);
    BlockColumn column(table, d.Depth);
    if (both && nextPower.Scale == 0)
    {
      BlockColumn nextColumn(next, d.Depth);
      column.RunWith(nextColumn, degrees - 4);
      column.Run(4);
      Add(column, first, 0, power, sums);
      Add(nextColumn, first + 4, 0, nextPower, sums);
      return afterNext;
    }
    int scale = power.Scale;
    column.RunScaled(degrees, scale);
    Add(column, first, scale, power, sums);
    if (both)
    {
      BlockColumn nextColumn(next, d.Depth);
      scale = nextPower.Scale;
      nextColumn.RunScaled(degrees - 4, scale);
      Add(nextColumn, first + 4, scale, nextPower, sums);
    }
    return afterNext;
  }

  template <int Derivatives, bool South>
  static PALPATE_INLINE OfAll<Derivatives>
  AllBlocks(const Real* table, int degree, const Direction& d, const Complexes& fourthPower)
  {
    OfAll<Derivatives> sums;
    ScaledPower<Set> power;
    for (int first = 0; first <= degree && !IsLost(power, degree); first += 8)
    {
      ScaledPower<Set> nextPower = power;
      nextPower.Advance(fourthPower);
      table = AddPair<Derivatives, South>(table, degree, first, d, power, nextPower, sums);
      power = nextPower;
      power.Advance(fourthPower);
    }
    return sums;
  }

  template <int Derivatives>
  static PALPATE_INLINE OfAll<Derivatives> SumBlocks(const Real* table, int degree,
                                                     const Direction& d, const Complexes& firstFour)
  {
    const Complexes fourthPower{LastLane(firstFour.Real), LastLane(firstFour.Imaginary)};
    return d.South ? AllBlocks<Derivatives, true>(table, degree, d, fourthPower)
                   : AllBlocks<Derivatives, false>(table, degree, d, fourthPower);
  }
};

/// R, and derivatives, of a model of any degree at one direction.
template <typename Set>
struct RecurrencePoint : RecurrenceSums<Set, 1>
{
  using Real = typename Set::Real;
  using Complexes = ComplexQuartet<Set>;
  using Direction = RecurrenceDirection<Set>;
  using Base = RecurrenceSums<Set, 1>;

  template <int Derivatives>
  static PALPATE_INLINE OrderSums<Set, Derivatives>
  SumBlocks(const Real* table, int degree, const Direction& d, const Complexes& firstFour)
  {
    return Base::template SumBlocks<Derivatives>(table, degree, d, firstFour).Function[0];
  }

  static PALPATE_INLINE void Refuse(Real* sample, int numbers)
  {
    for (int i = 0; i < numbers; ++i)
    {
      sample[i] = Real(__builtin_nan(""));
    }
  }

  static Real Value(const Real* table, int degree, const Real* direction) noexcept
  {
    const Direction d(direction);
    if (!d.IsUnit)
    {
      return Real(__builtin_nan(""));
    }
    const Complexes firstFour = FirstPowers(d.Unit.X, d.Unit.Y);
    return FinishValue(SumBlocks<0>(table, degree, d, firstFour), Base::Powers(firstFour),
                       ZonalTerms<Set>());
  }
  static void Gradient(const Real* table, int degree, const Real* direction, Real* sample) noexcept
  {
    const Direction d(direction);
    if (!d.IsUnit)
    {
      Refuse(sample, 4);
      return;
    }
    const Complexes firstFour = FirstPowers(d.Unit.X, d.Unit.Y);
    FinishGradient(SumBlocks<1>(table, degree, d, firstFour), Base::Powers(firstFour),
                   ZonalTerms<Set>(), d.Unit, sample);
  }
  static void Hessian(const Real* table, int degree, const Real* direction, Real* sample) noexcept
  {
    const Direction d(direction);
    if (!d.IsUnit)
    {
      Refuse(sample, 13);
      return;
    }
    const Complexes firstFour = FirstPowers(d.Unit.X, d.Unit.Y);
    FinishHessian(SumBlocks<2>(table, degree, d, firstFour), Base::Powers(firstFour),
                  ZonalTerms<Set>(), d.Unit, Real(2), sample);
  }

  static void Values(const Real* table, int degree, const Real* directions, long count,
                     Real* samples) noexcept
  {
    for (long i = 0; i < count; ++i)
    {
      samples[i] = Value(table, degree, directions + 3 * i);
    }
  }
  static void Gradients(const Real* table, int degree, const Real* directions, long count,
                        Real* samples) noexcept
  {
    for (long i = 0; i < count; ++i)
    {
      Gradient(table, degree, directions + 3 * i, samples + 4 * i);
    }
  }
  static void Hessians(const Real* table, int degree, const Real* directions, long count,
                       Real* samples) noexcept
  {
    for (long i = 0; i < count; ++i)
    {
      Hessian(table, degree, directions + 3 * i, samples + 13 * i);
    }
  }
};
} // namespace palpate::evaluation
