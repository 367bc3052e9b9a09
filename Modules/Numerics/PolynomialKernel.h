#pragma once

// The arithmetic of PolynomialTable. This header is compiled once for each instruction set, with
// different options, so it must not contain or include anything that another file could also
// instantiate: the linker would keep one copy, perhaps the one for the wrong machine. That is why
// everything here is templated on the instruction set, and nothing is included.

namespace palpate::polynomial
{
/// What every instruction set offers. `table` is PolynomialTable::Data() for its number of lanes, a
/// sample four doubles: the radius and the gradient on the unit sphere (tangent to it).
struct Kernel
{
  int Lanes;
  double (*Radius)(const double* table, int degree, const double* direction);
  void (*Evaluate)(const double* table, int degree, const double* direction, double* sample);
  /// `directions` are x, y, z of one direction after the other; `tableEnd` is one past the table.
  void (*EvaluateBatch)(const double* table, const double* tableEnd, int degree,
                        const double* directions, long count, double* samples);
};

/// `Set` describes an instruction set: `Vector`, a vector of doubles (GCC and Clang's vector
/// extension), and `Lanes`, how many it holds.
template <typename Set>
struct Arithmetic
{
  using Vector = typename Set::Vector;
  static constexpr int LaneCount = Set::Lanes;

  static inline __attribute__((always_inline)) double Sum(const Vector& v)
  {
    double sum = v[0] + v[1];
    for (int lane = 2; lane < LaneCount; lane += 2)
    {
      sum += v[lane] + v[lane + 1];
    }
    return sum;
  }

  // Powers w^(m-1) of a block of orders m, real and imaginary parts, and how to get to the next.
  struct Powers
  {
    Vector Real;
    Vector Imaginary;
    double StepReal; // w^LaneCount
    double StepImaginary;

    inline __attribute__((always_inline)) Powers(double x, double y)
    {
      const double squareReal = x * x - y * y;
      const double squareImaginary = 2.0 * (x * y);
      if constexpr (LaneCount == 2)
      {
        this->Real = Vector{1.0, x};
        this->Imaginary = Vector{0.0, y};
        this->StepReal = squareReal;
        this->StepImaginary = squareImaginary;
      }
      else
      {
        static_assert(LaneCount == 4, "powers are written out for two and four lanes");
        this->Real = Vector{1.0, x, squareReal, squareReal * x - squareImaginary * y};
        this->Imaginary = Vector{0.0, y, squareImaginary, squareReal * y + squareImaginary * x};
        this->StepReal = squareReal * squareReal - squareImaginary * squareImaginary;
        this->StepImaginary = 2.0 * (squareReal * squareImaginary);
      }
    }

    inline __attribute__((always_inline)) void Advance()
    {
      const Vector next = this->Real * this->StepReal - this->Imaginary * this->StepImaginary;
      this->Imaginary = this->Real * this->StepImaginary + this->Imaginary * this->StepReal;
      this->Real = next;
    }
  };

  // A pair of polynomials (cosine and sine terms of a block) and their derivatives in t, by
  // Horner's rule.
  struct Horner
  {
    Vector Cosine{};
    Vector Sine{};
    Vector CosineSlope{};
    Vector SineSlope{};

    inline __attribute__((always_inline)) const double* Run(const double* table, int count,
                                                            double t)
    {
      for (int k = 0; k < count; ++k, table += 2 * LaneCount)
      {
        this->CosineSlope = this->CosineSlope * t + this->Cosine;
        this->SineSlope = this->SineSlope * t + this->Sine;
        this->Cosine = this->Cosine * t + *reinterpret_cast<const Vector*>(table);
        this->Sine = this->Sine * t + *reinterpret_cast<const Vector*>(table + LaneCount);
      }
      return table;
    }

    inline __attribute__((always_inline)) const double* RunValues(const double* table, int count,
                                                                  double t)
    {
      for (int k = 0; k < count; ++k, table += 2 * LaneCount)
      {
        this->Cosine = this->Cosine * t + *reinterpret_cast<const Vector*>(table);
        this->Sine = this->Sine * t + *reinterpret_cast<const Vector*>(table + LaneCount);
      }
      return table;
    }
  };

  // Order 0: E + z O and its derivative in z.
  struct Order0
  {
    double Value;
    double Slope;

    inline __attribute__((always_inline)) Order0(const double* table, int count, double t, double z)
    {
      double even = 0.0;
      double odd = 0.0;
      double evenSlope = 0.0;
      double oddSlope = 0.0;
      for (int k = 0; k < count; ++k, table += 2)
      {
        evenSlope = evenSlope * t + even;
        oddSlope = oddSlope * t + odd;
        even = even * t + table[0];
        odd = odd * t + table[1];
      }
      this->Value = even + z * odd;
      this->Slope = odd + 4.0 * z * (evenSlope + z * oddSlope); // dt/dz = 4 z
    }
  };

  static inline __attribute__((always_inline)) int Order0Values(int degree)
  {
    const int values = 2 * (degree / 2 + 1);
    return (values + LaneCount - 1) / LaneCount * LaneCount;
  }

  static double Radius(const double* table, int degree, const double* direction)
  {
    const double x = direction[0];
    const double y = direction[1];
    const double z = direction[2];
    const double t = 1.0 - 2.0 * (x * x + y * y);
    const Order0 zero(table, degree / 2 + 1, t, z);
    table += Order0Values(degree);
    Powers powers(x, y);
    Vector alongX{};
    Vector alongY{};
    for (int order = 1; order <= degree; order += LaneCount)
    {
      Horner even;
      Horner odd;
      table = even.RunValues(table, (degree - order) / 2 + 1, t);
      table = odd.RunValues(table, (degree - order + 1) / 2, t);
      const Vector cosine = even.Cosine + z * odd.Cosine;
      const Vector sine = even.Sine + z * odd.Sine;
      alongX += cosine * powers.Real + sine * powers.Imaginary;
      alongY += sine * powers.Real - cosine * powers.Imaginary;
      powers.Advance();
    }
    return zero.Value + Sum(x * alongX + y * alongY);
  }

  // With D = cosine - i sine and W = w^(m-1): Re D w^m = x Re(D W) - y Im(D W), and the gradient of
  // w^m is m W (1, i).
  static void Evaluate(const double* table, int degree, const double* direction, double* sample)
  {
    const double x = direction[0];
    const double y = direction[1];
    const double z = direction[2];
    const double t = 1.0 - 2.0 * (x * x + y * y);
    const Order0 zero(table, degree / 2 + 1, t, z);
    table += Order0Values(degree);
    Powers powers(x, y);
    Vector order{};
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      order[lane] = 1.0 + lane;
    }
    Vector value{};
    Vector alongX{};
    Vector alongY{};
    Vector alongZ{};
    for (int first = 1; first <= degree; first += LaneCount)
    {
      Horner even;
      Horner odd;
      table = even.Run(table, (degree - first) / 2 + 1, t);
      table = odd.Run(table, (degree - first + 1) / 2, t);
      const Vector cosine = even.Cosine + z * odd.Cosine;
      const Vector sine = even.Sine + z * odd.Sine;
      const double fourZ = 4.0 * z;
      const Vector cosineSlope = odd.Cosine + fourZ * (even.CosineSlope + z * odd.CosineSlope);
      const Vector sineSlope = odd.Sine + fourZ * (even.SineSlope + z * odd.SineSlope);
      const Vector real = cosine * powers.Real + sine * powers.Imaginary;
      const Vector imaginary = sine * powers.Real - cosine * powers.Imaginary;
      const Vector realSlope = cosineSlope * powers.Real + sineSlope * powers.Imaginary;
      const Vector imaginarySlope = sineSlope * powers.Real - cosineSlope * powers.Imaginary;
      value += x * real + y * imaginary;
      alongX += order * real;
      alongY += order * imaginary;
      alongZ += x * realSlope + y * imaginarySlope;
      order += static_cast<double>(LaneCount);
      powers.Advance();
    }
    const double gx = Sum(alongX);
    const double gy = Sum(alongY);
    const double gz = zero.Slope + Sum(alongZ);
    const double radial = gx * x + gy * y + gz * z;
    sample[0] = zero.Value + Sum(value);
    sample[1] = gx - radial * x;
    sample[2] = gy - radial * y;
    sample[3] = gz - radial * z;
  }

  // Several points at once, one a lane. Horner's rule in w, from the highest order down:
  // V = D_m + w V, its derivative in w, and the same for dD_m/dz.
  struct NestedOrders
  {
    Vector Value[2]{};      // real and imaginary part
    Vector Derivative[2]{}; // in w
    Vector Slope[2]{};      // in z

    // The D_m of one order and its slope; `sine` terms make the negative imaginary part.
    inline __attribute__((always_inline)) void Add(const Vector& cosine, const Vector& sine,
                                                   const Vector& cosineSlope,
                                                   const Vector& sineSlope, const Vector& x,
                                                   const Vector& y)
    {
      const Vector real = this->Derivative[0] * x - this->Derivative[1] * y + this->Value[0];
      this->Derivative[1] = this->Derivative[0] * y + this->Derivative[1] * x + this->Value[1];
      this->Derivative[0] = real;
      const Vector value = this->Value[0] * x - this->Value[1] * y + cosine;
      this->Value[1] = this->Value[0] * y + this->Value[1] * x - sine;
      this->Value[0] = value;
      const Vector slope = this->Slope[0] * x - this->Slope[1] * y + cosineSlope;
      this->Slope[1] = this->Slope[0] * y + this->Slope[1] * x - sineSlope;
      this->Slope[0] = slope;
    }
  };

  // Horner's rule in t for one order at several points: `even` and `odd` point at the highest
  // coefficients of E and O, `sine` is the distance to the sine terms, `stride` to the next power.
  static inline __attribute__((always_inline)) void
  AddOrder(const double* even, int evenCount, const double* odd, int oddCount, int sine, int stride,
           const Vector& t, const Vector& x, const Vector& y, const Vector& z, NestedOrders& nested)
  {
    Vector evenCosine{};
    Vector evenSine{};
    Vector evenCosineSlope{};
    Vector evenSineSlope{};
    Vector oddCosine{};
    Vector oddSine{};
    Vector oddCosineSlope{};
    Vector oddSineSlope{};
    if (evenCount > oddCount)
    {
      evenCosine += even[0];
      evenSine += even[sine];
      even += stride;
    }
    for (int k = 0; k < oddCount; ++k, even += stride, odd += stride)
    {
      evenCosineSlope = evenCosineSlope * t + evenCosine;
      evenSineSlope = evenSineSlope * t + evenSine;
      oddCosineSlope = oddCosineSlope * t + oddCosine;
      oddSineSlope = oddSineSlope * t + oddSine;
      evenCosine = evenCosine * t + even[0];
      evenSine = evenSine * t + even[sine];
      oddCosine = oddCosine * t + odd[0];
      oddSine = oddSine * t + odd[sine];
    }
    const Vector fourZ = 4.0 * z;
    nested.Add(evenCosine + z * oddCosine, evenSine + z * oddSine,
               oddCosine + fourZ * (evenCosineSlope + z * oddCosineSlope),
               oddSine + fourZ * (evenSineSlope + z * oddSineSlope), x, y);
  }

  static inline __attribute__((always_inline)) void
  EvaluateLanes(const double* table, const double* tableEnd, int degree, const double* directions,
                double* samples)
  {
    Vector x{};
    Vector y{};
    Vector z{};
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      x[lane] = directions[3 * lane];
      y[lane] = directions[3 * lane + 1];
      z[lane] = directions[3 * lane + 2];
    }
    const Vector t = 1.0 - 2.0 * (x * x + y * y);
    NestedOrders nested;
    const double* block = tableEnd;
    for (int first = 1 + (degree - 1) / LaneCount * LaneCount; first >= 1; first -= LaneCount)
    {
      const int blockEven = (degree - first) / 2 + 1;
      const int blockOdd = (degree - first + 1) / 2;
      block -= 2 * LaneCount * (blockEven + blockOdd);
      for (int lane = LaneCount - 1; lane >= 0; --lane)
      {
        const int order = first + lane;
        if (order <= degree)
        {
          // Higher orders of a block have fewer terms; their first ones are zeros.
          const int evenCount = (degree - order) / 2 + 1;
          const int oddCount = (degree - order + 1) / 2;
          AddOrder(block + lane + 2 * LaneCount * (blockEven - evenCount), evenCount,
                   block + lane + 2 * LaneCount * (blockEven + blockOdd - oddCount), oddCount,
                   LaneCount, 2 * LaneCount, t, x, y, z, nested);
        }
      }
    }
    // Order 0: no sine terms, E and O in pairs.
    Vector even{};
    Vector odd{};
    Vector evenSlope{};
    Vector oddSlope{};
    for (int k = 0; k < degree / 2 + 1; ++k)
    {
      evenSlope = evenSlope * t + even;
      oddSlope = oddSlope * t + odd;
      even = even * t + table[2 * k];
      odd = odd * t + table[2 * k + 1];
    }
    const Vector none{};
    nested.Add(even + z * odd, none, odd + 4.0 * z * (evenSlope + z * oddSlope), none, x, y);
    const Vector gx = nested.Derivative[0];
    const Vector gy = -nested.Derivative[1];
    const Vector gz = nested.Slope[0];
    const Vector radial = gx * x + gy * y + gz * z;
    const Vector tangent[3] = {gx - radial * x, gy - radial * y, gz - radial * z};
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      samples[4 * lane] = nested.Value[0][lane];
      samples[4 * lane + 1] = tangent[0][lane];
      samples[4 * lane + 2] = tangent[1][lane];
      samples[4 * lane + 3] = tangent[2][lane];
    }
  }

  static void EvaluateBatch(const double* table, const double* tableEnd, int degree,
                            const double* directions, long count, double* samples)
  {
    long at = 0;
    for (; at + LaneCount <= count; at += LaneCount)
    {
      EvaluateLanes(table, tableEnd, degree, directions + 3 * at, samples + 4 * at);
    }
    for (; at < count; ++at)
    {
      Evaluate(table, degree, directions + 3 * at, samples + 4 * at);
    }
  }
};

/// For any machine: two lanes are SSE2 on x86-64 and NEON on arm64.
extern const Kernel Portable;
/// For x86-64 with AVX2 and FMA.
extern const Kernel Avx2;
} // namespace palpate::polynomial
