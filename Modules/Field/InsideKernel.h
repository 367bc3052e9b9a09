#pragma once

// Inside tests for several points at once. This header is compiled once for each instruction set,
// with different options, so it must not contain or include anything that another file could also
// instantiate. Products and sums are not contracted, so all sets give the same bits.

namespace palpate::inside
{
/// A material of one condition in a field with trilinear interpolation; see FieldGrid, BrickLayout,
/// MaterialMap and BrickedChannel.
struct Material
{
  double ToIndex[9]; ///< row by row; applied to point - Origin
  double Origin[3];
  int Nodes[3];
  int Bricks[3];
  const unsigned* Codes; ///< of the map
  unsigned Filled;
  const void* Blocks;
  unsigned long Stride; ///< numbers from block to block
  double Iso;
  double Sign; ///< 1: at least, -1: at most
};

/// Stored types: signed and unsigned char, signed and unsigned short, float, double.
constexpr int StoredTypes = 6;

/// What every instruction set offers: whether points (x, y, z one after the other) are inside, 1 or
/// 0, by the number of the stored type.
struct Kernel
{
  void (*AreInside[StoredTypes])(const Material& material, const double* points, long count,
                                 unsigned char* inside);
};

/// `Set` describes an instruction set: `Vector` and `Integers`, vectors of `Lanes` doubles and ints
/// (GCC and Clang's vector extension).
template <typename Set>
struct Arithmetic
{
  using Vector = typename Set::Vector;
  using Integers = typename Set::Integers;
  static constexpr int Lanes = Set::Lanes;
  static constexpr int Side = 9; // nodes of a brick along an axis

  // Where Lanes points lie.
  struct Places
  {
    Vector U[3];
    Integers Brick;
    Integers FirstNode;
    long long InGrid[Lanes]; // all bits, or none
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
      const auto isHere = (index >= 0.0) & (index <= static_cast<double>(m.Nodes[axis] - 1));
      isIn &= isHere;
      const Vector last = Vector{} + static_cast<double>(m.Nodes[axis] - 2);
      const Vector below = index < last ? index : last;
      cells[axis] = __builtin_convertvector(isHere ? below : Vector{}, Integers);
      places.U[axis] = index - __builtin_convertvector(cells[axis], Vector);
    }
    places.Brick =
        ((cells[2] >> 3) * m.Bricks[1] + (cells[1] >> 3)) * m.Bricks[0] + (cells[0] >> 3);
    places.FirstNode = ((cells[2] & 7) * Side + (cells[1] & 7)) * Side + (cells[0] & 7);
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

  // Two neighbours along i for each lane, as they follow each other in memory.
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
      first = __builtin_convertvector(low, Vector);
      second = __builtin_convertvector(high, Vector);
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

  template <typename T>
  static inline __attribute__((always_inline)) void
  TestLanes(const Material& m, const double* points, unsigned char* inside)
  {
    Places places;
    Locate(m, points, places);
    const T* nodes[Lanes];
    unsigned codes[Lanes];
    for (int lane = 0; lane < Lanes; ++lane)
    {
      codes[lane] = m.Codes[places.Brick[lane]];
      // Where the map says it all, any block will do.
      const unsigned long block = codes[lane] < m.Filled ? codes[lane] : 0;
      nodes[lane] = static_cast<const T*>(m.Blocks) + block * m.Stride + places.FirstNode[lane];
    }
    Vector rows[4] = {};
    for (int row = 0; row < 4; ++row)
    {
      Vector first{};
      Vector second{};
      LoadTwo(nodes, (row & 1) * Side + (row >> 1) * Side * Side, first, second);
      rows[row] = Mean(m.Sign * (first - m.Iso), m.Sign * (second - m.Iso), places.U[0]);
    }
    const Vector value =
        Mean(Mean(rows[0], rows[1], places.U[1]), Mean(rows[2], rows[3], places.U[1]), places.U[2]);
    const auto holds = value >= 0.0;
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const bool isStored = codes[lane] < m.Filled;
      const bool isInside = isStored ? holds[lane] != 0 : codes[lane] == m.Filled;
      inside[lane] = isInside && places.InGrid[lane] != 0 ? 1 : 0;
    }
  }

  template <typename T>
  static void AreInside(const Material& m, const double* points, long count, unsigned char* inside)
  {
    long p = 0;
    for (; p + Lanes <= count; p += Lanes)
    {
      TestLanes<T>(m, points + 3 * p, inside + p);
    }
    if (p < count)
    {
      double rest[3 * Lanes] = {};
      unsigned char answers[Lanes];
      for (long n = 0; n < 3 * (count - p); ++n)
      {
        rest[n] = points[3 * p + n];
      }
      TestLanes<T>(m, rest, answers);
      for (long n = p; n < count; ++n)
      {
        inside[n] = answers[n - p];
      }
    }
  }

  static constexpr Kernel All()
  {
    return {{AreInside<signed char>, AreInside<unsigned char>, AreInside<short>,
             AreInside<unsigned short>, AreInside<float>, AreInside<double>}};
  }
};

/// In InsideKernel.cxx, which is compiled for AVX2.
extern const Kernel Avx2;
} // namespace palpate::inside
