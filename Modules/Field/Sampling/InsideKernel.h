#pragma once

// Inside tests for several points at once. This header is compiled once for each instruction set,
// with different options, so it must not contain or include anything that another file could also
// instantiate. Products and sums are not contracted, so all sets give the same bits.

namespace palpate::inside
{
/// A material of one condition; see FieldGrid, BrickLayout, MaterialMap and BrickedChannel.
struct Material
{
  double ToIndex[9]; ///< row by row; applied to point - Origin
  double Origin[3];
  double LastCell[3]; ///< of the grid
  int Bricks[3];
  const unsigned* Codes; ///< of the MaterialMap
  unsigned Filled;
  const void* Blocks;
  unsigned long Stride; ///< elements from block to block
  double Iso;
  double Sign; ///< 1: at least, -1: at most
};

/// Stored types: signed and unsigned char, signed and unsigned short, float, double.
constexpr int StoredTypes = 6;

/// Whether points (consecutive x, y, z) are inside, 1 or 0.
using Test = void (*)(const Material& material, const double* points, long count,
                      unsigned char* inside);

/// As BrickLayout::Shift.
constexpr int Shift = 3;

/// Functions of every instruction set, by the index of the stored type. B-spline coefficients are
/// floating point: the last two.
struct Kernel
{
  Test Trilinear[StoredTypes];
  Test Tricubic[StoredTypes];
};

/// `Set` describes an instruction set: `Vector` and `Integers`, vectors of `Lanes` doubles and ints
/// (GCC and Clang's vector extension).
template <typename Set>
struct Arithmetic
{
  using Vector = typename Set::Vector;
  using Integers = typename Set::Integers;
  static constexpr int Lanes = Set::Lanes;
  // Cells of Lanes points.
  struct Places
  {
    Vector U[3];
    Integers Brick;
    Integers FirstNode;
    long long InGrid[Lanes]; // all bits set, or none
  };

  static inline __attribute__((always_inline)) Vector Coordinate(const double* first)
  {
    if constexpr (Lanes == 4)
    {
      return Vector{first[0], first[3], first[6], first[9]};
    }
    else
    {
      return Vector{first[0], first[3]};
    }
  }

  // Elements of a vector or an array as doubles. Written out, so that compilers emit one
  // instruction where available.
  template <typename T>
  static inline __attribute__((always_inline)) Vector Widened(const T& from)
  {
    if constexpr (Lanes == 4)
    {
      return Vector{static_cast<double>(from[0]), static_cast<double>(from[1]),
                    static_cast<double>(from[2]), static_cast<double>(from[3])};
    }
    else
    {
      return Vector{static_cast<double>(from[0]), static_cast<double>(from[1])};
    }
  }

  template <int Side>
  static inline __attribute__((always_inline)) void Locate(const Material& m, const double* points,
                                                           Places& places)
  {
    const Vector offset[3] = {Coordinate(points) - m.Origin[0],
                              Coordinate(points + 1) - m.Origin[1],
                              Coordinate(points + 2) - m.Origin[2]};
    Integers cells[3] = {};
    auto isIn = offset[0] == offset[0];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double* row = m.ToIndex + 3 * axis;
      const Vector index = row[0] * offset[0] + row[1] * offset[1] + row[2] * offset[2];
      const Vector zero{};
      const Vector last = zero + m.LastCell[axis];
      const auto isHere = (index >= zero) & (index <= last + 1.0);
      isIn &= isHere;
      const Vector below = index < last ? index : last;
      cells[axis] = __builtin_convertvector(isHere ? below : zero, Integers);
      places.U[axis] = index - Widened(cells[axis]);
    }
    constexpr int Low = (1 << Shift) - 1;
    places.Brick = ((cells[2] >> Shift) * m.Bricks[1] + (cells[1] >> Shift)) * m.Bricks[0] +
                   (cells[0] >> Shift);
    places.FirstNode = ((cells[2] & Low) * Side + (cells[1] & Low)) * Side + (cells[0] & Low);
    for (int lane = 0; lane < Lanes; ++lane)
    {
      places.InGrid[lane] = isIn[lane];
    }
  }

  static inline __attribute__((always_inline)) Vector Mean(const Vector& a, const Vector& b,
                                                           const Vector& u)
  {
    return a * (1.0 - u) + b * u;
  }

  // Two neighbours along i for each lane, adjacent in memory.
  template <typename T>
  static inline __attribute__((always_inline)) void LoadTwo(const T* const* nodes, int offset,
                                                            Vector& first, Vector& second)
  {
    if constexpr (sizeof(T) == 2)
    {
      Integers both{};
      for (int lane = 0; lane < Lanes; ++lane)
      {
        int two = 0;
        __builtin_memcpy(&two, nodes[lane] + offset, sizeof(two));
        both[lane] = two;
      }
      constexpr bool isSigned = T(-1) < T(0);
      const Integers low = isSigned ? both << 16 >> 16 : both & 0xFFFF;
      const Integers high = isSigned ? both >> 16 : both >> 16 & 0xFFFF;
      first = Widened(low);
      second = Widened(high);
    }
    else
    {
      for (int lane = 0; lane < Lanes; ++lane)
      {
        first[lane] = static_cast<double>(nodes[lane][offset]);
        second[lane] = static_cast<double>(nodes[lane][offset + 1]);
      }
    }
  }

  // The values at Lanes points, given their cells' first nodes.
  template <int Side, typename T>
  static inline __attribute__((always_inline)) Vector
  LinearValue(const Material& m, const T* const* nodes, const Vector* u)
  {
    Vector rows[4] = {};
    for (int row = 0; row < 4; ++row)
    {
      Vector first{};
      Vector second{};
      LoadTwo(nodes, (row & 1) * Side + (row >> 1) * Side * Side, first, second);
      rows[row] = Mean(first - m.Iso, second - m.Iso, u[0]);
    }
    return Mean(Mean(rows[0], rows[1], u[1]), Mean(rows[2], rows[3], u[1]), u[2]);
  }

  // The four basis functions of the cubic B-spline, as in TricubicCell.
  static inline __attribute__((always_inline)) void CubicWeights(const Vector& u, Vector* weights)
  {
    constexpr double Sixth = 1.0 / 6.0;
    const Vector v = 1.0 - u;
    const Vector low = v * v * v;
    const Vector high = u * u * u;
    weights[0] = Sixth * low;
    weights[1] = Sixth * (4.0 - 2.0 * (u * u + u * u + u * u) + 3.0 * high);
    weights[2] = Sixth * (4.0 - 2.0 * (v * v + v * v + v * v) + 3.0 * low);
    weights[3] = Sixth * high;
  }

  // Four coefficients along i, minus the iso-value, and their sums.
  struct Row
  {
    static constexpr int Parts = 4 / Lanes;
    Vector Part[Parts];

    template <typename T>
    inline __attribute__((always_inline)) void Add(const T* nodes, double iso, double weight,
                                                   bool isFirst)
    {
      for (int part = 0; part < Parts; ++part)
      {
        const Vector term = (Widened(nodes + Lanes * part) - iso) * weight;
        this->Part[part] = isFirst ? term : this->Part[part] + term;
      }
    }
    inline __attribute__((always_inline)) void Add(const Row& row, double weight, bool isFirst)
    {
      for (int part = 0; part < Parts; ++part)
      {
        const Vector term = row.Part[part] * weight;
        this->Part[part] = isFirst ? term : this->Part[part] + term;
      }
    }
    inline __attribute__((always_inline)) double At(int i) const
    {
      return this->Part[i / Lanes][i % Lanes];
    }
  };

  // The value at one point: along k, then j, then i, in the order of TricubicCell.
  template <int Side, typename T>
  static inline __attribute__((always_inline)) double
  CubicValueOf(const T* nodes, double iso, const double* x, const double* y, const double* z)
  {
    Row slice{};
    for (int j = 0; j < 4; ++j)
    {
      Row column{};
      for (int k = 0; k < 4; ++k)
      {
        column.Add(nodes + (k * Side + j) * Side, iso, z[k], k == 0);
      }
      slice.Add(column, y[j], j == 0);
    }
    return slice.At(0) * x[0] + slice.At(1) * x[1] + slice.At(2) * x[2] + slice.At(3) * x[3];
  }

  template <int Side, typename T>
  static inline __attribute__((always_inline)) Vector
  CubicValue(const Material& m, const T* const* nodes, const Vector* u)
  {
    double weights[3][4][Lanes]; // [axis][function][lane]
    for (int axis = 0; axis < 3; ++axis)
    {
      Vector functions[4] = {};
      CubicWeights(u[axis], functions);
      __builtin_memcpy(weights[axis], functions, sizeof(functions));
    }
    Vector values{};
    for (int lane = 0; lane < Lanes; ++lane)
    {
      double ofLane[3][4];
      for (int axis = 0; axis < 3; ++axis)
      {
        for (int function = 0; function < 4; ++function)
        {
          ofLane[axis][function] = weights[axis][function][lane];
        }
      }
      values[lane] = CubicValueOf<Side>(nodes[lane], m.Iso, ofLane[0], ofLane[1], ofLane[2]);
    }
    return values;
  }

  template <typename T, bool isCubic>
  static inline __attribute__((always_inline)) void
  TestLanes(const Material& m, const double* points, unsigned char* inside)
  {
    constexpr int Side = (1 << Shift) + (isCubic ? 3 : 1); // nodes of a brick along an axis
    Places places;
    Locate<Side>(m, points, places);
    const T* nodes[Lanes];
    unsigned codes[Lanes];
    for (int lane = 0; lane < Lanes; ++lane)
    {
      codes[lane] = m.Codes[places.Brick[lane]];
      // If the map decides alone, any block will do.
      const unsigned long block = codes[lane] < m.Filled ? codes[lane] : 0;
      nodes[lane] = static_cast<const T*>(m.Blocks) + block * m.Stride + places.FirstNode[lane];
    }
    Vector value{};
    if constexpr (isCubic)
    {
      value = CubicValue<Side>(m, nodes, places.U);
    }
    else
    {
      value = LinearValue<Side>(m, nodes, places.U);
    }
    // Sums and means of negated numbers are exactly the negated ones.
    const auto holds = m.Sign * value >= 0.0;
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const bool isStored = codes[lane] < m.Filled;
      const bool isInside = isStored ? holds[lane] != 0 : codes[lane] == m.Filled;
      inside[lane] = isInside && places.InGrid[lane] != 0 ? 1 : 0;
    }
  }

  template <typename T, bool isCubic>
  static void AreInside(const Material& material, const double* points, long count,
                        unsigned char* inside)
  {
    const Material m = material; // local copy: cannot alias the results
    long p = 0;
    for (; p + Lanes <= count; p += Lanes)
    {
      TestLanes<T, isCubic>(m, points + 3 * p, inside + p);
    }
    if (p < count)
    {
      double rest[3 * Lanes] = {};
      unsigned char answers[Lanes];
      for (long n = 0; n < 3 * (count - p); ++n)
      {
        rest[n] = points[3 * p + n];
      }
      TestLanes<T, isCubic>(m, rest, answers);
      for (long n = p; n < count; ++n)
      {
        inside[n] = answers[n - p];
      }
    }
  }

  static constexpr Kernel All()
  {
    return {{AreInside<signed char, false>, AreInside<unsigned char, false>,
             AreInside<short, false>, AreInside<unsigned short, false>, AreInside<float, false>,
             AreInside<double, false>},
            {nullptr, nullptr, nullptr, nullptr, AreInside<float, true>, AreInside<double, true>}};
  }
};

/// In InsideKernel.cxx, which is compiled for AVX2.
extern const Kernel Avx2;
} // namespace palpate::inside
